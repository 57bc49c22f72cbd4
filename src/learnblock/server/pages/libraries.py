"""Handlers of messages about libraries.

Nothing in a library is run here: it is read, and runs only as a part of a program.
"""

from collections.abc import Callable, Mapping

from anyio import to_thread

from learnblock.blocks.known import all_configurations
from learnblock.errors import Diagnostic, LearnBlockError, ProjectError, phrase_of
from learnblock.extensions import libraries
from learnblock.extensions.libraries import ENDING, Library, Shelved
from learnblock.i18n import Phrase
from learnblock.language.edit.extraction import extracted, with_needed
from learnblock.language.tree.nodes import Def, Program
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _list(page: Page, _: messages.ListLibraries) -> None:
    page.send(await to_thread.run_sync(listed))


@HANDLERS.add
async def _list_exportable(page: Page, _: messages.ListExportable) -> None:
    program = page.part.document.block_tree
    page.send(await to_thread.run_sync(_exportable, program))


@HANDLERS.add
async def _read(page: Page, message: messages.ReadLibraries) -> None:
    page.send(await to_thread.run_sync(_looked_at, message.files))


@HANDLERS.add
async def _import(page: Page, message: messages.ImportLibraries) -> None:
    def install() -> None:
        libraries.install(map(_renamed, message.files), replace=message.replace)

    await _changing(page, install)


@HANDLERS.add
async def _remove(page: Page, message: messages.RemoveLibrary) -> None:
    await _changing(page, lambda: libraries.remove(message.name))


@HANDLERS.add
async def _download(page: Page, message: messages.DownloadLibrary) -> None:
    page.send(_made(await to_thread.run_sync(libraries.installed, message.name)))


@HANDLERS.add
async def _make(page: Page, message: messages.MakeLibrary) -> None:
    program = page.part.document.block_tree

    def make() -> Library:
        manifest = libraries.manifest(message.name, message.version, message.title)
        return libraries.make(manifest, program, message.functions, message.own, page.session.name)

    page.send(_made(await to_thread.run_sync(make)))


@HANDLERS.add
async def _convert(page: Page, message: messages.ConvertLibrary) -> None:
    page.send(await to_thread.run_sync(_converted, message))


@HANDLERS.add
async def _use(page: Page, message: messages.UseLibrary) -> None:
    await to_thread.run_sync(libraries.installed, message.name)
    await page.part.change(lambda document: document.with_import(message.name))


async def _changing(page: Page, change: Callable[[], None]) -> None:
    await to_thread.run_sync(change)
    await page.sessions.renew_blocks(page.session)
    page.sessions.send(await to_thread.run_sync(listed))


# Answers.


def listed() -> messages.Libraries:
    """All installed libraries."""
    return messages.Libraries(tuple(map(_shelved, libraries.shelved())))


def _shelved(shelved: Shelved) -> messages.InstalledLibrary:
    if shelved.library is None:
        return messages.InstalledLibrary(shelved.name, problem=shelved.problem)
    return _described(shelved.library)


def _described(library: Library) -> messages.InstalledLibrary:
    manifest = library.manifest
    return messages.InstalledLibrary(
        library.name,
        manifest.version,
        dict(manifest.title),
        manifest.description,
        tuple(library.skills),
    )


def _made(library: Library) -> messages.LibraryMade:
    return messages.LibraryMade(library.name + ENDING, libraries.pack(library))


def _converted(message: messages.ConvertLibrary) -> messages.LibraryConverted:
    """A library of the original LearnBlock.

    Raises:
        FileError: it is damaged, or can only be used in a program.
    """
    from learnblock import importing  # noqa: PLC0415 - few pages open such files

    files = importing.LibraryFiles(
        message.filename, message.content, message.python, message.configuration
    )
    imported = importing.import_library(files, all_configurations())
    if imported.library is None:
        reason = Phrase("import-only-program", name=message.filename)
        raise ProjectError(message.filename, [Diagnostic("only-program", reason)])
    converted = _made(imported.library)
    return messages.LibraryConverted(
        converted.filename, converted.content, imported.report.changed, imported.report.missing
    )


# Files to import.


def _renamed(file: messages.LibraryFile) -> Library:
    return libraries.renamed(libraries.unpack(file.content, file.filename), file.renames)


def _looked_at(files: tuple[messages.LibraryFile, ...]) -> messages.LibrariesRead:
    opened = [_opened(file) for file in files]
    clashes = libraries.clashes(library for library, _ in opened if library is not None)
    there = libraries.readable()
    return messages.LibrariesRead(
        tuple(
            _file(file, library, problem, there, clashes)
            for file, (library, problem) in zip(files, opened, strict=True)
        )
    )


def _opened(file: messages.LibraryFile) -> tuple[Library | None, Phrase | None]:
    """Read the library in a file; return it with its possible new names and its problems."""
    try:
        library = libraries.unpack(file.content, file.filename)
    except LearnBlockError as error:
        return None, phrase_of(error)
    try:
        return libraries.renamed(library, file.renames), None
    except LearnBlockError as error:
        return library, phrase_of(error)


def _file(
    file: messages.LibraryFile,
    library: Library | None,
    problem: Phrase | None,
    there: Mapping[str, Library],
    clashes: tuple[libraries.Clash, ...],
) -> messages.LibraryRead:
    if library is None:
        return messages.LibraryRead(file.filename, problem=problem)
    before = there.get(library.name)
    return messages.LibraryRead(
        file.filename,
        _described(library),
        before.manifest.version if before else "",
        before is None or library.manifest.order > before.manifest.order,
        tuple(
            messages.SkillClash(clash.skill, clash.place)
            for clash in clashes
            if clash.library == library.name
        ),
        problem,
    )


# The contents of a new library.


def _exportable(program: Program) -> messages.Exportable:
    functions = tuple(_function(program, function) for function in program.functions.values())
    own = tuple(messages.ExportableBlocks(*entry) for entry in libraries.own_skills().items())
    return messages.Exportable(functions, own)


def _function(program: Program, function: Def) -> messages.ExportableFunction:
    others = tuple(name for name in with_needed(program, [function.name]) if name != function.name)
    try:
        extracted(program, [function.name], "")
    except LearnBlockError as error:
        return messages.ExportableFunction(
            function.name, function.parameters, others, phrase_of(error)
        )
    return messages.ExportableFunction(function.name, function.parameters, others)
