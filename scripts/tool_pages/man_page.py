# SPDX-License-Identifier: BSD-3-Clause
"""A man page, in the roff of man(7), from a program's --help."""
import os
import re
import time


def escaped(text):
    """Text as roff takes it: no escape, hyphens that can be searched for, no line that looks like a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    text = text.replace("~", "\\(ti").replace("^", "\\(ha")
    return "\n".join("\\&" + line if line.startswith((".", "\\(aq")) else line for line in text.splitlines())


def value_marked(value):
    """NAME.json: what the user puts in is in italics, what is typed as it is printed is bold."""
    parts = re.findall(r"[A-Z][A-Z0-9]*(?![a-z])|[a-z][\w.-]*|[^A-Za-z]+|.", value)
    fonts = {True: "\\fI", False: "\\fB"}
    return "".join(escaped(part) if not part[0].isalpha() else fonts[part[0].isupper()] + escaped(part) + "\\fR"
                   for part in parts)


def usage_marked(usage):
    """The line of the synopsis: the program's name is bold."""
    name = re.match(r"[a-z_]+(?: [a-z]+)*", usage).group(0)
    return f".B {escaped(name)}\n{value_marked(usage[len(name):].strip())}"


def entry_marked(entry):
    if entry.names[0].startswith("-"):
        head = ", ".join(f"\\fB{escaped(name)}\\fR" for name in entry.names)
        if entry.value:
            head += " " + value_marked(entry.value)
    else:
        head = f"\\fI{escaped(entry.names[0])}\\fR" + (" ..." if "..." in entry.value else "")
    text = entry.text
    if entry.notes:
        stop = "" if not text or text.endswith(".") else "."
        text = f"{text}{stop} {' '.join(entry.notes)}".strip()
    return f".TP\n{head}\n{escaped(text)}"


def codes_marked(codes):
    lines = []
    for code, meaning in codes:
        lines.append(f".TP\n.B {code}\n{escaped(meaning[:1].upper() + meaning[1:])}.")
    return lines


def remarks_marked(remarks):
    return [line for remark in remarks for line in (".PP", escaped(remark))]


def sections_marked(command):
    """Arguments and options are sections of the page; the groups of options are parts of theirs."""
    lines = []
    for heading, entries in command.sections.items():
        title = {"Positionals": ".SH ARGUMENTS", "Options": ".SH OPTIONS"}.get(heading, f".SS {heading}")
        lines += [title] + [entry_marked(entry) for entry in entries]
    return lines


def subcommand_marked(command, program):
    """A part of the program's page, without what the program says too."""
    lines = [f'.SS "{escaped(command.name)}"', usage_marked(command.usage), ".PP", escaped(command.description)]
    for entries in command.sections.values():
        lines += [entry_marked(entry) for entry in entries if "--help" not in entry.names]
    lines += remarks_marked(remark for remark in command.remarks() if remark not in program.remarks())
    if command.exit_codes() != program.exit_codes():
        lines += [".PP", "Exit status:"] + codes_marked(command.exit_codes())
    return lines


def today():
    """The date of the page: the day it is built, or what a reproducible build says that is."""
    seconds = int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))
    return time.strftime("%Y-%m-%d", time.gmtime(seconds))


def man_page(command, version, see_also):
    """The page of a program; `see_also` names the others."""
    about = command.in_one_line()
    lines = [f'.TH {command.name.upper()} 1 "{today()}" "EPCC segmentation {version}" "User Commands"',
             ".SH NAME", f"{escaped(command.name)} \\- {escaped(about[:1].lower() + about[1:])}",
             ".SH SYNOPSIS", usage_marked(command.usage)]
    for subcommand in command.subcommands:
        lines += [".br", usage_marked(subcommand.usage)]
    environment = [remark for remark in command.remarks() if re.match(r"[A-Z_]+=", remark)]
    lines += [".SH DESCRIPTION", escaped(command.description)]
    lines += remarks_marked(remark for remark in command.remarks() if remark not in environment)
    lines += sections_marked(command)
    if command.subcommands:
        lines.append(".SH SUBCOMMANDS")
        for subcommand in command.subcommands:
            lines += subcommand_marked(subcommand, command)
    if environment:
        lines.append(".SH ENVIRONMENT")
        lines += [f".TP\n.B {escaped(line.partition('=')[0])}\n{escaped(line)}" for line in environment]
    if command.exit_codes():
        lines += [".SH EXIT STATUS"] + codes_marked(command.exit_codes())
    others = [f".BR {escaped(name)} (1)" for name in sorted(see_also) if name != command.name]
    if others:
        lines += [".SH SEE ALSO", " ,\n".join(others)]
    return "\n".join(lines) + "\n"
