# SPDX-License-Identifier: BSD-3-Clause
"""The script by which bash completes a program's command line, from its --help: options, the words that an option
takes, files with the right ending, folders."""
import re
from pathlib import Path

from help_text import output_of

TEMPLATE = Path(__file__).with_name("completion.bash.in")
WORD = r"[a-z][\w-]*"


def defined_words(command):
    """What the help says of words in capitals: `FORMAT one of native, abw`, `PRESET is one of d435i, ...`."""
    texts = [command.description, command.footer] + [e.text for es in command.sections.values() for e in es]
    words = {}
    for text in texts:
        for name, listed in re.findall(rf"\b([A-Z]+) (?:is )?one of ({WORD}(?:,\s+{WORD})*)", text):
            words[name] = re.split(r",\s+", listed)
    return words


def alternatives(text):
    """`Scan lines: columns | rows | both: all that ...` gives columns, rows, both."""
    parts = re.sub(r"\s*\([^)]*\)", "", text).split(" | ")
    if len(parts) < 2:
        return []
    parts[0] = parts[0].split()[-1]
    parts[-1] = re.split(r"[:;,]? ", parts[-1])[0]
    return [part.strip(" ;") for part in parts]


def typed_words(choices, words):
    """The choices that can be typed: `auto`, `white:SENSOR` with each SENSOR, `poly:K1,K2,K3` as far as `poly:`."""
    typed = []
    for choice in choices:
        found = re.fullmatch(rf"({WORD}:)?([A-Z]+)", choice)
        if re.fullmatch(WORD, choice):
            typed.append(choice)
        elif found and found.group(2) in words:
            typed += [(found.group(1) or "") + word for word in words[found.group(2)]]
        elif ":" in choice and re.match(WORD, choice):
            typed.append(choice[:choice.index(":") + 1])
    return typed


def endings(text):
    return re.findall(r"\.([a-z]{3,4})\b", text)


def listed_names(entry, program, options):
    """`Any parameter, as epcc_segment --list-parameters names it`: the names in the first column of the table that the
    program beside this one prints, but those that are options."""
    found = re.search(r"as (epcc_\w+) (--list-[\w-]+) names", entry.text)
    if not found:
        return []
    table = output_of(Path(program).with_name(found.group(1)), found.group(2))
    return [name for name in re.findall(r"^\| `([\w.]+)` \|", table, re.MULTILINE) if f"--{name}" not in options]


def actions_of(entry, words, program, options=()):
    """The calls of the script's functions that complete what follows the option, or the argument."""
    actions = []

    def add(function, arguments=()):
        call = " ".join([function, *dict.fromkeys(arguments)])
        if call not in actions:
            actions.append(call)

    is_argument = not entry.names[0].startswith("-")
    value = entry.names[0] if is_argument else entry.value
    choices = value.split("|") if "|" in value else alternatives(entry.text)
    if is_argument and re.fullmatch(rf"{WORD}(, {WORD})*( or {WORD})?", entry.text):
        choices = re.split(r", | or ", entry.text)
    typed = typed_words(choices, words)
    if typed:
        add("_epcc_words", typed)
    if value.startswith("A,B,..."):
        listed = re.search(rf"\(({WORD}(?:,{WORD})+)\)", entry.text)
        add("_epcc_list", listed.group(1).split(",") if listed else [])
    names = listed_names(entry, program, options)
    if names:
        add("_epcc_words", [f"{name}=" for name in names])
    named = [ending for text in [value, *choices] if re.match(r"[A-Z]", text) for ending in endings(text)]
    if named:
        add("_epcc_files", named + (endings(entry.text) if endings(value) else []))
    elif "DIR" in value or "FOLDER" in value:
        add("_epcc_folders")
    elif not typed and (is_argument or value == "NAME"):
        formats = re.match(r"FOLDER or ([A-Z]+):FOLDER", entry.text)
        if formats:
            add("_epcc_words", [f"{word}:" for word in words.get(formats.group(1), [])])
        add("_epcc_folders" if formats else "_epcc_files")
    return actions


def names_of(command):
    return [name for entry in command.options() for name in entry.names]


def command_cases(command, subcommand, words, program):
    """Lines of the script's `case "$subcommand $before"`, for the program or one of its subcommands."""
    lines = []
    for entry in command.options():
        if entry.value:
            pattern = "|".join(f'"{subcommand} {name}"' for name in entry.names)
            actions = actions_of(entry, words, program, names_of(command))
            lines.append(f"    {pattern}) {'; '.join(actions) or ':'} ;;")
    return lines


def rest_case(command, subcommand, option_names, words, program):
    """What may stand where no option waits for its value."""
    actions = [f'_epcc_options {" ".join(option_names)}']
    subcommands = [other.name.split()[-1] for other in command.subcommands]
    if subcommands:
        actions.append("_epcc_words " + " ".join(subcommands))
    for entry in command.arguments():
        actions += actions_of(entry, words, program)
    return f'    "{subcommand} "*) {"; ".join(actions)} ;;'


def bash_completion(command, program):
    words = defined_words(command)
    cases = []
    for one in [*command.subcommands, command]:
        subcommand = one.name.partition(" ")[2]
        names = names_of(one)
        cases += command_cases(one, subcommand, words, program)
        if subcommand and set(names) <= {"-h", "--help"}:  # the program's options are its options
            cases += command_cases(command, subcommand, words, program)
            names = names_of(command)
        cases.append(rest_case(one, subcommand, names, words, program))
    subcommands = "|".join(other.name.split()[-1] for other in command.subcommands) or "''"
    text = TEMPLATE.read_text(encoding="utf-8")
    for mark, value in (("PROGRAM", command.name), ("SUBCOMMANDS", subcommands), ("CASES", "\n".join(cases))):
        text = text.replace(f"@{mark}@", value)
    return text
