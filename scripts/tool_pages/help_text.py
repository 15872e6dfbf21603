# SPDX-License-Identifier: BSD-3-Clause
"""Reads what a program's --help says (CLI11's form) into descriptions, options, arguments and exit codes."""
import os
import re
import subprocess
from dataclasses import dataclass, field

DESCRIPTION_COLUMN = 30  # where CLI11 starts what an entry is about
LINE = 90  # characters of a command in one line


@dataclass
class Entry:
    """An option, an argument or a subcommand: ["-h", "--help"], what follows it ("OUT.png"), what it is for."""
    names: list
    value: str
    text: str
    notes: list = field(default_factory=list)  # "Required.", "0 to 1024.": what CLI11 adds to the value


@dataclass
class Command:
    """A program, or a subcommand of it."""
    name: str
    description: str = ""
    usage: str = ""
    sections: dict = field(default_factory=dict)  # heading -> entries, in their order
    footer: str = ""
    subcommands: list = field(default_factory=list)

    def options(self):
        return [entry for entries in self.sections.values() for entry in entries if entry.names[0].startswith("-")]

    def arguments(self):
        return self.sections.get("Positionals", [])

    def in_one_line(self):
        """The first sentence, or as many of its clauses as fit a line."""
        sentence = re.split(r"\.\s+(?=[A-Z])|\.$", self.description, maxsplit=1)[0].replace("\n", " ")
        ends = [found.start() for found in re.finditer(r"[,:;] ", sentence) if found.start() <= LINE]
        return sentence[:ends[-1]] if len(sentence) > LINE and ends else sentence

    def remarks(self):
        """The footer without the exit codes, in paragraphs: those whose lines end a sentence."""
        text = self.footer.partition("Exit codes: ")[0].strip()
        return re.split(r"(?<=\.)\n", text) if text else []

    def exit_codes(self):
        """[("0", "done"), ...]"""
        text = " ".join(self.footer.partition("Exit codes: ")[2].split()).rstrip(".")
        return re.findall(r"(\d) (.*?)(?=, \d |$)", text)


def output_of(program, *arguments):
    """What the program prints; in English, whatever the terminal."""
    environment = dict(os.environ, LC_ALL="C.UTF-8")
    done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, check=True, env=environment, timeout=60)
    return done.stdout.decode("utf-8")


def read_command(program):
    """The program's help with that of its subcommands."""
    name = os.path.basename(program)
    command = parse(name, output_of(program, "--help"))
    listed = [entry.names[0] for entry in command.sections.pop("Subcommands", [])]
    mentioned = re.findall(rf"\bsee {name} (\w+) --help", command.footer)
    for subcommand in dict.fromkeys(listed + mentioned):
        command.subcommands.append(parse(f"{name} {subcommand}", output_of(program, subcommand, "--help")))
    return command


def parse(name, text):
    command = Command(name)
    lines = text.splitlines()
    start = next((i for i, line in enumerate(lines) if line.startswith("Usage: ")), None)
    if start is None:
        raise ValueError(f"{name} --help has no line that starts with 'Usage: '")
    command.description = "\n".join(lines[:start]).strip()
    command.usage = lines[start][len("Usage: "):]
    entries, footer = None, []
    for line, next_line in zip(lines[start + 1:], lines[start + 2:] + [""]):
        heading = re.fullmatch(r"(\w[\w ]*):", line)
        if heading:
            entries = command.sections.setdefault(heading.group(1), [])
        elif not line.strip():
            continue
        elif not line.startswith(" "):
            footer.append(line)
        elif entries is None or footer:
            raise ValueError(f"{name} --help: what is this? {line}")
        elif line.startswith(" " * DESCRIPTION_COLUMN):
            entries[-1].text = f"{entries[-1].text} {line.strip()}".strip()
        else:
            entries.append(entry_of(line, next_line.startswith(" " * DESCRIPTION_COLUMN)))
    command.footer = "\n".join(footer)
    if not command.options():
        raise ValueError(f"{name} --help names no option")
    return command


def entry_of(line, goes_on):
    """`  --jobs J:INT in [0 - 1024]  Frames at a time`; what is behind two blanks is on the next line if need be."""
    head, _, text = line.strip().partition("  ")
    if not text and not goes_on and line[DESCRIPTION_COLUMN - 1:DESCRIPTION_COLUMN] == " ":
        head, text = line[:DESCRIPTION_COLUMN].strip(), line[DESCRIPTION_COLUMN:]  # a name as long as its column
    first, _, rest = head.partition(" ")
    entry = Entry(first.split(","), "", text.strip())
    entry.value = without_notes(rest, entry.notes)
    return entry


def without_notes(value, notes):
    """The value's name; what CLI11 says of its type, default and company becomes sentences."""
    def take(pattern, sentence):
        nonlocal value
        found = re.search(pattern, value)
        if found:
            notes.append(sentence.format(*(part.strip().replace(" ", ", ") for part in found.groups())))
            value = value.replace(found.group(0), "")

    take(r"\s*Excludes: ((?:--[\w-]+ ?)+)", "Not together with {}.")
    take(r"\s*Needs: ((?:--[\w-]+ ?)+)", "Only with {}.")
    take(r"\s*\bREQUIRED\b", "Required.")
    take(r":?\bINT in \[(\d+) - (\d+)\]", "{} to {}.")
    take(r"(?<=INT|OAT)=(\S+)", "Default: {}.")
    value = re.sub(r"(?: \.\.\.)+$", " ...", value.strip())
    return {"INT": "N", "FLOAT": "F"}.get(value, value)
