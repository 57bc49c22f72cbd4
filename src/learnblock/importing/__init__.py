"""Import programs of the original LearnBlock, the tool of the paper, of versions 1 to 3."""

from learnblock.importing.conversion import ENDING, FindLibrary, Imported, import_project
from learnblock.importing.library_folder import (
    LIBRARY_ENDING,
    ImportedLibrary,
    LibraryFiles,
    find_library,
    import_library,
    import_text,
)
from learnblock.importing.pickle_reader import LARGEST
from learnblock.importing.report import ImportReport

__all__ = [
    "ENDING",
    "LARGEST",
    "LIBRARY_ENDING",
    "FindLibrary",
    "ImportReport",
    "Imported",
    "ImportedLibrary",
    "LibraryFiles",
    "find_library",
    "import_library",
    "import_project",
    "import_text",
]
