"""What is done when a page lists, imports, makes and uses libraries.

Nothing in a library is run here: it is read, and runs only as a part of a program.
"""

from collections.abc import Callable, Mapping

from anyio import to_thread

from learnblock import library
from learnblock.errors import LearnBlockError
from learnblock.language.extraction import extracted, with_needed
from learnblock.language.nodes import Def, Program
from learnblock.library import ENDING, Library, Shelved
from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page
from learnblock.server.pages.sentences import sentence


async def _list(page: Page, _: messages.ListLibraries) -> None:
    page.tell(await to_thread.run_sync(_all))


async def _list_exportable(page: Page, _: messages.ListExportable) -> None:
    program = page.session.document.block_tree
    page.tell(await to_thread.run_sync(_exportable, program))


async def _read(page: Page, message: messages.ReadLibraries) -> None:
    page.tell(await to_thread.run_sync(_looked_at, message.files))


async def _import(page: Page, message: messages.ImportLibraries) -> None:
    def install() -> None:
        library.install(map(_renamed, message.files), replace=message.replace)

    await _changing(page, install)


async def _remove(page: Page, message: messages.RemoveLibrary) -> None:
    await _changing(page, lambda: library.remove(message.name))


async def _download(page: Page, message: messages.DownloadLibrary) -> None:
    page.tell(_made(await to_thread.run_sync(library.installed, message.name)))


async def _make(page: Page, message: messages.MakeLibrary) -> None:
    program = page.session.document.block_tree

    def make() -> Library:
        manifest = library.manifest(message.name, message.version, message.title)
        return library.make(manifest, program, message.functions, message.own, page.session.name)

    page.tell(_made(await to_thread.run_sync(make)))


async def _use(page: Page, message: messages.UseLibrary) -> None:
    await to_thread.run_sync(library.installed, message.name)
    await page.session.change(lambda document: document.with_import(message.name))


async def _changing(page: Page, change: Callable[[], None]) -> None:
    await to_thread.run_sync(change)
    await page.sessions.renew_blocks(page.session)
    page.sessions.tell(await to_thread.run_sync(_all))


# What is told.


def _all() -> messages.Libraries:
    return messages.Libraries(tuple(map(_shelved, library.shelved())))


def _shelved(one: Shelved) -> messages.InstalledLibrary:
    if one.library is None:
        return messages.InstalledLibrary(one.name, problem=one.problem)
    return _described(one.library)


def _described(one: Library) -> messages.InstalledLibrary:
    manifest = one.manifest
    return messages.InstalledLibrary(
        one.name,
        manifest.version,
        dict(manifest.title),
        manifest.description,
        tuple(one.skills),
    )


def _made(one: Library) -> messages.LibraryMade:
    return messages.LibraryMade(one.name + ENDING, library.pack(one))


# Files that are to be imported.


def _renamed(file: messages.LibraryFile) -> Library:
    return library.renamed(library.unpack(file.content, file.filename), file.renames)


def _looked_at(files: tuple[messages.LibraryFile, ...]) -> messages.LibrariesRead:
    found = [_opened(file) for file in files]
    clashes = library.clashes(one for one, _ in found if one is not None)
    there = library.readable()
    return messages.LibrariesRead(
        tuple(
            _file(file, one, problem, there, clashes)
            for file, (one, problem) in zip(files, found, strict=True)
        )
    )


def _opened(file: messages.LibraryFile) -> tuple[Library | None, str]:
    """The library in a file, with the new names that can be given, and what is wrong."""
    try:
        one = library.unpack(file.content, file.filename)
    except LearnBlockError as error:
        return None, sentence(error)
    try:
        return library.renamed(one, file.renames), ""
    except LearnBlockError as error:
        return one, sentence(error)


def _file(
    file: messages.LibraryFile,
    one: Library | None,
    problem: str,
    there: Mapping[str, Library],
    clashes: tuple[library.Clash, ...],
) -> messages.LibraryRead:
    if one is None:
        return messages.LibraryRead(file.filename, problem=problem)
    before = there.get(one.name)
    return messages.LibraryRead(
        file.filename,
        _described(one),
        before.manifest.version if before else "",
        before is None or one.manifest.order > before.manifest.order,
        tuple(
            messages.SkillClash(clash.skill, clash.place)
            for clash in clashes
            if clash.library == one.name
        ),
        problem,
    )


# What a library can be made of.


def _exportable(program: Program) -> messages.Exportable:
    functions = tuple(_function(program, one) for one in program.functions.values())
    own = tuple(messages.ExportableBlocks(*found) for found in library.own_skills().items())
    return messages.Exportable(functions, own)


def _function(program: Program, one: Def) -> messages.ExportableFunction:
    others = tuple(name for name in with_needed(program, [one.name]) if name != one.name)
    try:
        extracted(program, [one.name], "")
    except LearnBlockError as error:
        return messages.ExportableFunction(one.name, one.parameters, others, sentence(error))
    return messages.ExportableFunction(one.name, one.parameters, others)


HANDLERS: Mapping[type, Handler] = {
    messages.ListLibraries: _list,
    messages.ListExportable: _list_exportable,
    messages.ReadLibraries: _read,
    messages.ImportLibraries: _import,
    messages.RemoveLibrary: _remove,
    messages.DownloadLibrary: _download,
    messages.MakeLibrary: _make,
    messages.UseLibrary: _use,
}
