"""What documents and comments name is there: files, folders, links, sources in the bibliography.

Every file or folder in `code` style, and every link, of README.md, CONTRIBUTING.md and docs/ exists;
no tracked file cites a document (WORD.md) that the project has not, or an issue by number; and each
key in brackets, as [Loop 1987], is that of an entry in docs/references.bib."""

import pathlib
import re
import subprocess
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = [PROJECT / "README.md", PROJECT / "CONTRIBUTING.md", *sorted(PROJECT.glob("docs/**/*.md"))]
FENCED = re.compile(r"^```(.*?)^```$", re.MULTILINE | re.DOTALL)
CREATED = re.compile(r"^```\w+ create (\S+)$", re.MULTILINE)
CODE = re.compile(r"`([^`\s]+)`")
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
NAMED = re.compile(r"\.(h|cpp|md|bib|py)$")
CITED = re.compile(r"\b[A-Za-z][\w-]*\.md\b")
ISSUE = re.compile(r"\b[Ii]ssue #?\d")
SOURCE = re.compile(r"\[([A-Z][\w–-]+(?:, [A-Z]\w+)*) (\d{4})(?:[,; ][^\]]*)?\]")
KEYED = re.compile(r"\[(ADS|BGSK|KS|CDM)\b[^\]]*\]")


def tracked():
    listing = subprocess.run(["git", "-C", PROJECT, "ls-files", "-z", "--cached", "--others",
                              "--exclude-standard"], capture_output=True, text=True)
    if listing.returncode != 0:  # a source archive
        return [p for p in PROJECT.rglob("*") if p.is_file() and "build" not in p.parts]
    return [PROJECT / name for name in listing.stdout.split("\0") if name]


def texts():
    """The lines of every tracked text file, but those that are about paths that are not there."""
    for path in tracked():
        if path.is_file() and "tests/tools/" not in str(path) and path.suffix not in (".png", ".pdf"):
            try:
                lines = path.read_text().splitlines()
            except UnicodeDecodeError:
                continue
            yield from ((path.relative_to(PROJECT), i, line) for i, line in enumerate(lines, 1))


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folders = {p.name for p in (PROJECT / "src/limn").iterdir()}
        cls.top = {p.name for p in PROJECT.iterdir()} - {"build"}
        cls.names = {p.name for p in tracked()}

    def is_path(self, word):
        """Whether this word in `code` style means a file or folder of the project."""
        if re.search(r"[^\w./-]|[A-Z]{4}", word) and not word.endswith(".md"):
            return False  # a pattern, as split_NAME.cpp
        first = word.split("/")[0]
        return bool(NAMED.search(word)) or ("/" in word and first in self.folders | self.top | {"limn"})

    def exists(self, word, document):
        if "/" not in word:
            return word in self.names
        places = (PROJECT, PROJECT / "src", PROJECT / "src/limn", document.parent)
        return any((place / word).exists() for place in places)

    def test_named_files_exist(self):
        missing = []
        for document in DOCUMENTS:
            text = document.read_text()
            made = set(CREATED.findall(text))
            prose = FENCED.sub("", text)
            for word in CODE.findall(prose):
                if self.is_path(word) and word not in made and not self.exists(word, document):
                    missing.append(f"{document.name}: `{word}`")
            for link in LINK.findall(prose):
                if "://" not in link and not (document.parent / link).exists():
                    missing.append(f"{document.name}: ({link})")
        self.assertEqual(missing, [])

    def test_cited_documents_exist(self):
        found = [f"{path}:{i}: {word}" for path, i, line in texts()
                 for word in CITED.findall(line)
                 if word not in self.names and not word[:-3].isupper()]  # FILE.md: any
        self.assertEqual(found, [])

    def test_no_issue_is_cited(self):
        self.assertEqual([f"{path}:{i}" for path, i, line in texts() if ISSUE.search(line)], [])

    def test_sources_are_in_the_bibliography(self):
        entries = (PROJECT / "docs/references.bib").read_text()
        keys = set(re.findall(r"@\w+\{(\w+),", entries)) | set(re.findall(r"key=\{(\w+)\}", entries))
        plain = {key.lower() for key in keys}
        unknown = []
        for document in DOCUMENTS:
            prose = FENCED.sub("", document.read_text())
            for names, year in SOURCE.findall(prose):
                if re.sub(r"[, –-]", "", names).lower() + year not in plain:
                    unknown.append(f"{document.name}: [{names} {year}]")
            unknown += [f"{document.name}: [{key}]" for key in KEYED.findall(prose) if key not in keys]
        self.assertEqual(unknown, [])


if __name__ == "__main__":
    unittest.main()
