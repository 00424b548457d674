#!/usr/bin/env python3
"""Checks what the documentation says about the repository.

    .ci/checkDocs.py [PROGRAM]

Links between pages and their anchors; files, keys of a scene, scenes, presets and tests that text and commands name;
pages that code names. Tables of docs/ and README.md have at most six columns, those of docs/results hold what
bench/data says, and no page of docs/ names a commit.
CITATION.cff has the version of CMakeLists.txt. With PROGRAM (build/release/restenosisFoam) also the options of its
commands, that docs/guide/schema.md is what `PROGRAM schema --markdown` prints, and that PROGRAM accepts the scenes of
the tutorial. Every finding is a line, and the exit status is 1 where there is one.
"""
import fnmatch
import itertools
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

# Words that have a plainer one. They are sought in the folders of WORDS_SOUGHT_IN: comments and texts alike.
WORDS = ["anew", "asleep", "awake", "calm", "cramped", "doubts?", "firm", "leash", "looks?", "nobody", "pieces?", "restless",
         "rooms?", "rows?", "sight", "takes?", "unsure", "way", "who", "whom", "whose", "yields?"]
WORDS_SOUGHT_IN = ["tissue"]

ROOT = pathlib.Path(__file__).resolve().parent.parent
TRACKED = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.split("\n")
FILES = {name for name in TRACKED if name and (ROOT / name).exists()}
FOLDERS = {str(parent) for name in FILES for parent in pathlib.PurePosixPath(name).parents} - {"."}
BASENAMES = {name.rsplit("/", 1)[-1] for name in FILES}
SCHEMA = "docs/guide/schema.md"
TUTORIAL = "docs/guide/tutorial"
MOST_COLUMNS = 6
COMMANDS = ["run", "check", "compare", "tradeoff", "report", "bench", "schema"]

findings = []


def find(page, line, what):
    findings.append(f"{page}:{line}: {what}")


def slug(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


class Page:
    def __init__(self, name):
        self.name = name
        self.prose = []  # (line number, text), code blocks left out
        self.code = []   # (line number, command), lines that end in a backslash joined
        self.anchors = set()
        self.read((ROOT / name).read_text(encoding="utf-8").split("\n"))

    def read(self, lines):
        inCode = False
        joined = None
        for number, line in enumerate(lines, 1):
            if line.strip().startswith("```"):
                inCode = not inCode
            elif not inCode:
                self.prose.append((number, line))
                if line.startswith("#"):
                    self.addAnchor(slug(line.lstrip("#").strip()))
            else:
                first, text = joined or (number, "")
                joined = (first, text + line.rstrip("\\"))
                if not line.endswith("\\"):
                    self.code.append(joined)
                    joined = None

    def addAnchor(self, anchor):
        given, count = anchor, 0
        while given in self.anchors:
            count += 1
            given = f"{anchor}-{count}"
        self.anchors.add(given)


def checkLinks(page, pages):
    for number, line in page.prose:
        for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            name = page.name
            if path:
                absolute = (ROOT / page.name).parent / path
                if not absolute.exists():
                    find(page.name, number, f"link to {path}, which does not exist")
                    continue
                name = str(absolute.resolve().relative_to(ROOT))
            if anchor and name in pages and anchor not in pages[name].anchors:
                find(page.name, number, f"link to #{anchor}, which {name} does not have")


def checkTables(page):
    for number, line in page.prose:
        columns = len(re.findall(r"(?<!\\)\|", line)) - 1
        if re.fullmatch(r"\|[-:| ]+\|", line) and columns > MOST_COLUMNS:
            find(page.name, number, f"a table of {columns} columns: at most {MOST_COLUMNS}")


def checkMeasured():
    """Tables and figures of docs/results against bench/data."""
    checked = subprocess.run([sys.executable, ROOT / "bench/draw", "--check"], capture_output=True, text=True)
    findings.extend((checked.stdout or checked.stderr).splitlines() if checked.returncode else [])


def checkCommits(page):
    """Numbers of a machine or a seed may be of such digits too: only what git knows counts."""
    for number, line in page.prose + page.code:
        for word in re.findall(r"\b[0-9a-f]{7,40}\b", line):
            known = subprocess.run(["git", "rev-parse", "-q", "--verify", f"{word}^{{commit}}"], cwd=ROOT,
                                   capture_output=True)
            if known.returncode == 0:
                find(page.name, number, f"{word} is a commit: git has the history")


def existsAsNamed(path):
    path = path.rstrip("/")
    return path in FILES or path in FOLDERS or any(fnmatch.fnmatch(name, path) for name in FILES)


def checkPaths(page):
    """Names of files in backticks: paths from the root, and sources by their name alone."""
    roots = {folder for folder in FOLDERS if "/" not in folder}
    for number, line in page.prose:
        for quoted in re.findall(r"`([^`\s]+)`", line):
            if re.search(r"\b(My|my|mine)|FILE|NAME|[<{$=]", quoted):
                continue  # names that stand for others
            quoted = re.sub(r"\.h/\.cpp$", ".h", quoted)
            if re.fullmatch(r"[\w.*-]+(/[\w.*-]+)+/?", quoted) and quoted.split("/")[0] in roots:
                if not existsAsNamed(quoted):
                    find(page.name, number, f"{quoted} does not exist")
            elif re.fullmatch(r"[A-Z]\w+\.(h|cpp|cmake)", quoted) and quoted not in BASENAMES:
                find(page.name, number, f"there is no file {quoted}")


def readKeys():
    """{section: keys} of the schema's tables."""
    keys, section = {}, None
    for line in (ROOT / SCHEMA).read_text(encoding="utf-8").split("\n"):
        heading = re.fullmatch(r"## \[(\w+)\]", line)
        if heading:
            section = heading[1]
            keys[section] = set()
        elif section and re.match(r"\| \w+ \|", line):
            keys[section].add(line.split("|")[1].strip())
    return keys


def writtenNames():
    """Names that the program writes into its results: strings of bridge/."""
    return {name for path in FILES if path.startswith("bridge/") and path.endswith(".cpp")
            for name in re.findall(r"\"(\w+)\"", (ROOT / path).read_text(encoding="utf-8"))}


def checkKeys(page, keys, written):
    for number, line in page.prose + page.code:
        named = re.findall(r"--(?:set|vary) \"?([a-z]\w*)\.(\w+)=", line)
        named += [(section, key) for section, key in re.findall(r"`([a-z]\w*)\.([a-z]\w*)(?: = [^`]*)?`", line)
                  if section in keys and key not in written and f"{section}.{key}" not in ("scene.toml", "vessel.png")]
        for section, key in named:
            if key not in keys.get(section, ()):
                find(page.name, number, f"no key {section}.{key} in a scene")
        for section in re.findall(r"--set (\w+)=(?:absent|present)", line):
            if section != "SECTION" and section not in keys and section != "flow":
                find(page.name, number, f"no section {section} in a scene")
        for scene in re.findall(r"\bscenes/\w+\.toml", line):
            if scene not in FILES and "my" not in scene:
                find(page.name, number, f"{scene} does not exist")


def testNames():
    names = set()
    for name in FILES:
        if name.startswith("tests/") and name.endswith(".cpp"):
            text = (ROOT / name).read_text(encoding="utf-8")
            names |= {f"{s}.{t}" for s, t in re.findall(r"TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", text)}
            names |= {f"{p}/{s}.*" for p, s in re.findall(r"INSTANTIATE_TEST_SUITE_P\(\s*(\w+),\s*(\w+)", text)}
            names |= {f"{s}/*.{t}" for s, t in re.findall(r"TYPED_TEST\(\s*(\w+),\s*(\w+)\)", text)}
    return names


def optionsOf(program):
    """{command: its options}"""
    options = {}
    for command in COMMANDS:
        text = subprocess.run([program, command, "--help"], check=True, capture_output=True, text=True).stdout
        options[command] = set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", text))
    return options


def words(command):
    try:
        return shlex.split(command, comments=True)
    except ValueError:
        return command.split()


def checkCommands(page, presets, tests, options, measurements):
    for number, command in page.code:
        given = words(command)
        if given[:1] == ["bench/run"]:
            for word in itertools.takewhile(lambda word: word != "&&", given[1:]):
                if not word.startswith("-") and word not in measurements:
                    find(page.name, number, f"bench/run has no {word}")
        for word, following in zip(given, given[1:]):
            if word == "--preset" and following not in presets:
                find(page.name, number, f"no preset {following}")
            if re.search(r"\.py$", following) and word.startswith("python3") and following not in FILES:
                find(page.name, number, f"{following} does not exist")
        for word in given:
            pattern = re.fullmatch(r"--gtest_filter=(.*)", word)
            for part in pattern[1].split(":") if pattern else []:
                if not any(fnmatch.fnmatch(test, part.lstrip("-")) for test in tests):
                    find(page.name, number, f"no test fits {part}")
        starts = [i for i, word in enumerate(given) if word.endswith("/restenosisFoam") or word == "restenosisFoam"]
        for start in starts if options else []:
            command = given[start + 1] if start + 1 < len(given) else ""
            if command not in COMMANDS:
                if not command.startswith("-") and re.fullmatch(r"[a-z]+", command):
                    find(page.name, number, f"no command {command}")
                continue
            for word in given[start + 2:]:
                if word in ("&&", "||", "|", ";", ">", "&"):
                    break
                option = re.match(r"--?[A-Za-z][\w-]*", word)
                if option and option[0] not in options[command]:
                    find(page.name, number, f"{command} has no option {option[0]}")


def checkSchema(program):
    printed = subprocess.run([program, "schema", "--markdown"], check=True, capture_output=True, text=True).stdout
    if printed != (ROOT / SCHEMA).read_text(encoding="utf-8"):
        find(SCHEMA, 1, f"not current; {program} schema --markdown > {SCHEMA} makes it")


def checkCitation():
    cmake = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"project\(restenosisFoam VERSION ([\d.]+)", cmake)[1]
    if f"\nversion: {version}\n" not in (ROOT / "CITATION.cff").read_text(encoding="utf-8"):
        find("CITATION.cff", 1, f"not of version {version}, which CMakeLists.txt has")


def checkTutorial(program):
    """The tutorial shows its scenes as they are, and the program accepts them with the lumen of its script."""
    page = (ROOT / f"{TUTORIAL}.md").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / TUTORIAL, folder, dirs_exist_ok=True)
        subprocess.run([sys.executable, "lumen.py"], cwd=folder, check=True)
        for scene in sorted(pathlib.Path(folder).glob("*.toml")):
            checked = subprocess.run([program, "check", scene.name], cwd=folder, capture_output=True, text=True)
            if checked.returncode:
                find(f"{TUTORIAL}/{scene.name}", 1, checked.stderr.strip())
            if scene.read_text(encoding="utf-8") not in page:
                find(f"{TUTORIAL}.md", 1, f"does not show {scene.name} as it is")


def checkMentions():
    """Pages that code and scenes name."""
    for name in sorted(FILES):
        if re.search(r"\.(h|cpp|cmake|py|toml|txt)$", name):
            for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").split("\n"), 1):
                for page in re.findall(r"\bdocs/[\w/.-]+\.md", line):
                    if page not in FILES:
                        find(name, number, f"{page} does not exist")


def checkWords():
    pattern = re.compile(r"\b(" + "|".join(WORDS) + r")\b", re.IGNORECASE)
    for name in sorted(FILES):
        if any(name.startswith(folder + "/") for folder in WORDS_SOUGHT_IN):
            for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").split("\n"), 1):
                for word in pattern.findall(line):
                    find(name, number, f"'{word}' has a plainer word")


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve()) if len(sys.argv) > 1 else None
    presets = {preset["name"] for preset in
               json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]}
    pages = {name: Page(name) for name in sorted(FILES) if name.endswith(".md")}
    keys, written, tests = readKeys(), writtenNames(), testNames()
    options = optionsOf(program) if program else None
    listed = subprocess.run([sys.executable, ROOT / "bench/run", "--list"], check=True, capture_output=True, text=True)
    measurements = {line.split()[0] for line in listed.stdout.splitlines()}
    for page in pages.values():
        checkLinks(page, pages)
        checkPaths(page)
        checkKeys(page, keys, written)
        checkCommands(page, presets, tests, options, measurements)
        if page.name.startswith("docs/"):
            checkCommits(page)
        if page.name.startswith("docs/") or page.name == "README.md":
            checkTables(page)
    if program:
        checkSchema(program)
        checkTutorial(program)
    checkCitation()
    checkMeasured()
    checkMentions()
    checkWords()
    print("\n".join(findings) if findings else f"{len(pages)} pages agree with the repository")
    return 1 if findings else 0


sys.exit(main())
