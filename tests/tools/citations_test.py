"""Every citation in a comment, as [ADS §2.3] or [Loop 1987], is in docs/references.bib."""

import pathlib
import re
import unicodedata
import unittest

PROJECT = pathlib.Path(__file__).parents[2]
FOLDERS = ("src", "apps", "tests", "bench", "fuzz", "examples")


def plain(text):
    """Without accents, those of TeX too."""
    text = re.sub(r'\{?\\["\'`^]\{?(\w)\}?\}?', r"\1", text)
    text = unicodedata.normalize("NFKD", text)
    return "".join(c for c in text if not unicodedata.combining(c)).replace("{", "").replace("}", "")


def entries(bib):
    """[(names that cite the entry, surnames, year)] of a text in BibTeX."""
    found = []
    for text in re.split(r"(?m)^@", bib)[1:]:
        key = re.match(r"\w+\{(\w+)", text).group(1)
        alias = re.search(r"\bkey=\{(\w+)\}", text)
        author = re.search(r"author=\{(.*?)\}, \w+=\{", text)
        year = re.search(r"year=\{(\d+)\}", text)
        surnames = {plain(name).split(",")[0].strip()
                    for name in (author.group(1).split(" and ") if author else [])}
        found.append(({key} | ({alias.group(1)} if alias else set()), surnames,
                      year.group(1) if year else None))
    return found


def citations(comment):
    """The citations in a comment: what stands in brackets, begins with a name and is no code."""
    for bracket in re.findall(r"(?<![\w\]])\[([A-Z][^\W_]+\b(?!::|[_(])[^\[\]]*)\](?!\()", comment):
        yield from (part.strip() for part in bracket.split(";"))


def is_known(citation, bib):
    words = re.match(r"[\w\s,.&()-]*", plain(citation)).group(0)
    first = words.split()[0].rstrip(",")
    if any(first in names for names, _, _ in bib):
        return True
    year = re.search(r"\b(1[89]|20)\d\d\b", words)
    for _, surnames, of_entry in bib:
        if first in surnames and (year is None or year.group(0) == of_entry):
            return True
    return False


class Citations(unittest.TestCase):
    def test_of_all_sources(self):
        bib = entries((PROJECT / "docs/references.bib").read_text())
        count = 0
        unknown = []
        for folder in FOLDERS:
            for path in sorted((PROJECT / folder).rglob("*")):
                if path.suffix not in (".h", ".cpp"):
                    continue
                for number, line in enumerate(path.read_text().splitlines(), 1):
                    comment = re.search(r"(?:^|\s)//+(.*)", line)
                    for citation in citations(comment.group(1)) if comment else ():
                        count += 1
                        if not is_known(citation, bib):
                            unknown.append(f"{path.relative_to(PROJECT)}:{number}: [{citation}]")
        self.assertEqual(unknown, [], "add them to docs/references.bib")
        self.assertGreater(count, 50)

    def test_what_is_found(self):
        self.assertEqual(list(citations(" a [ADS §2.3] b [CDM §8; Jia1998] c[0] [x] [Kind::a] [A](b)")),
                         ["ADS §2.3", "CDM §8", "Jia1998"])
        bib = entries('@book{AbcDe1999, key={AD}, author={Abc, X. and D{\\"o}, Y}, title={t}, year={1999}}\n'
                      "@manual{Only, title={t}}\n")
        for known in ("AbcDe1999, §3", "AD Fig. 1", "Abc", "Abc & Dö 1999", "Dö, Abc 1999", "Only, 2"):
            self.assertTrue(is_known(known, bib), known)
        for wrong in ("AbcDe1998", "Abc 1998", "Nobody 1999", "ADx"):
            self.assertFalse(is_known(wrong, bib), wrong)


if __name__ == "__main__":
    unittest.main()
