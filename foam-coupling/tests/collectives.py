#!/usr/bin/env python3
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Looks for collective calls that some ranks may leave out.

The contract (README.md, "Collective calls"):

  1. A function that makes a collective call says `Collective.` in the comment
     of its declaration (a local function, of its definition).
  2. A collective call stands behind no condition that ranks can see
     differently. Where it stands behind one at all (if, for, while, switch,
     ?:, &&, ||), a comment `all ranks alike` on a line of that condition, or on the line
     above it, says so; such a condition may not name size(), empty() or owned.

Reads the sources as text, in the style of this folder: braces on every branch.
Prints one line a violation and exits with 1 when there is any.

Usage: collectives.py [FOLDER ...]        collectives.py --test
"""
import re
import sys
from pathlib import Path

PRIMITIVE = re.compile(
    r"\b(?:reduce|returnReduce|g(?:Sum|Max|Min|Average)(?:Mag|Prod|Sqr)?"
    r"|gatherList|scatterList|exchange(?:Sizes)?|combineGather|combineScatter"
    r"|listCombineGather|listCombineScatter|adjustPhi|swapBoundaryCellList"
    r"|correctBoundaryConditions|needReference|setRefCell|setReference"
    r"|finishedSends|handOver|evaluate(?:All)?Coupled(?:<\w+>)?|savedField<\w+>"
    r"|MPI_(?:All\w+|Barrier|Bcast|Gather\w*|Reduce\w*|Scatter\w*))\s*\("
    r"|\bfv[cm]::\w+\s*\(|(?<!ldlt)(?:\.|->)solve\s*\(|\bsumShared_?\s*\("
    r"|(?:->|\.)(?:sumShared|own)\s*\(|interpolation<\w+>::New\s*\("
    r"|\btypeHeaderOk<uniform\w+>|(?:turbulence_->|transport_\.|fvOptions\.)correct\s*\(")
CONTROL = re.compile(r"^(?:else\s+)?(if|for|forAll\w*|while|switch)\b|^(else|do|case\b.*|default)\b")
LOCAL = re.compile(r"(?:\.|->)(?:size|empty)\(\)|\bowned\b")
RANGE = re.compile(r"for\s*\([^;]*[^:]:[^:][^;]*\)$")
MARK = "all ranks alike"
COLLECTIVE = re.compile(r"\b[Cc]ollective\b")
# conditions that are the same on all ranks by what they ask
ALIKE = re.compile(
    r"!?(?:Pstream::parRun\(\)|pimple_\.\w+\(\)|(?:\w+\.)*needReference\(\)"
    r"|properties_\.\w+\(.*?\)(?: [!=]= \" *\")?|\w*[sS]moothing_?(?:\.|->)active\(\)"
    r"|(?:faces_\.)?is ?\(.*\)|faces_\.orthogonal\(\)|smoothing"
    r"|returnReduce ?\(.*\)|sumShared_?|true|case .*|runTime_\.writeTime\(\))")
# whose functions are called through what names
OBJECTS = {
    "ledger_": "momentumLedger", "sums_": "particleSums", "sums": "particleSums",
    "history_": "voidFractionHistory", "forces_": "particleForces",
    "force": "forceModel", "smoothing": "smoothingModel", "smoothing_": "smoothingModel",
    "mapping_": "voidFractionModel", "coupling": "particleCoupling", "fluid": "fluidSolver",
    "quiet_": "quietFluid", "self_": "selfDisturbanceModel", "faces_": "faceOperators",
    "stats": "couplingStatistics", "stats_": "couplingStatistics"}


def split(text):
    """The text without strings and comments, and the comment of each line."""
    code, notes = [], {}
    i, line = 0, 1
    while i < len(text):
        two = text[i:i + 2]
        if two == "//" or two == "/*":
            end = text.find("\n", i) if two == "//" else text.find("*/", i) + 2
            end = len(text) if end < 2 else end
            comment = text[i:end]
            for k, part in enumerate(comment.split("\n")):
                notes[line + k] = notes.get(line + k, "") + part
            code.append(re.sub(r"[^\n]", " ", comment))
            line += comment.count("\n")
            i = end
        elif text[i] in "\"'":
            end = i + 1
            while text[end] != text[i]:
                end += 2 if text[end] == "\\" else 1
            code.append('"' + " " * (end - i - 1) + '"')
            i = end + 1
        else:
            line += text[i] == "\n"
            code.append(text[i])
            i += 1
    # preprocessor lines say nothing here
    return re.sub(r"(?m)^#.*$", lambda m: " " * len(m[0]), "".join(code)), notes


def above(notes, line):
    """The block of comment lines that ends just above a line."""
    words = []
    while line - 1 in notes:
        line -= 1
        words.append(notes[line])
    return " ".join(reversed(words))


def name_of(head):
    """The name of the function that a head declares, None if it is none."""
    head = re.sub(r"\s+", " ", head.strip())
    head = re.sub(r"^(?:template ?<[^{}]*?> ?(?=\w))", "", head)
    m = re.match(r"(?:[\w:<>,&*~\[\] ]*?[ :&*>])??((?:\w+::)*~?\w+) ?\(", head)
    if not m or CONTROL.match(head) or re.match(r"(class|struct|namespace|enum|union|return)\b", head):
        return None
    return m[1].split("::")[-1]


def class_of(head):
    """The class whose function a head defines, None for a free one."""
    m = re.search(r"(\w+)::~?\w+\s*\(", head)
    return m[1] if m else None


class Source:
    def __init__(self, path, text):
        self.path = path
        self.code, self.notes = split(text)

    def line(self, at):
        return self.code.count("\n", 0, at) + 1

    def declared(self):
        """Names of functions whose comment says that they are collective, by class,
        and those of others."""
        names, others = set(), set()
        classes = {self.path.stem, *re.findall(r"(?m)^\s*class (\w+)$", self.code)}
        for m in re.finditer(r"\b(~?\w+)\s*\(", self.code):
            start = max(self.code.rfind(c, 0, m.start()) for c in ";{}:") + 1
            while start < len(self.code) and self.code[start].isspace():
                start += 1
            if "(" in self.code[start:m.start()] or (
                    start == m.start() and m[1] not in classes):
                continue
            if COLLECTIVE.search(above(self.notes, self.line(start))):
                names |= {(c, m[1]) for c in classes}
            elif self.path.suffix == ".H" and not re.search(
                    r"=|\b(?:return|new|else)\b", self.code[start:m.start()]):
                others |= {(c, m[1]) for c in classes}
        return names, others

    def violations(self, names):
        """(line, text) of each call that breaks the contract."""
        own = re.compile(r"(?:\b(\w+)(?:\(\))?(?:\.|->)|(?<![:.>\w]))(%s)\s*\("
                         % "|".join(sorted({n for _, n in names}))) if names else None
        stack, start, found = [], 0, []
        depth, last = 0, {}
        for at, c in enumerate(self.code):
            if c == "(":
                depth += 1
            elif c == ")":
                depth -= 1
            if c not in "{};" or (c == ";" and depth and self.in_for(start, at)):
                continue
            head = self.code[start:at]
            first = start + len(head) - len(head.lstrip())
            inside = any(kind == "function" for kind, *_ in stack)
            if c == "{":
                control = CONTROL.match(head.strip())
                if not inside:
                    name = name_of(head)
                    kind = "function" if name else "scope"
                    level = (kind, name, first, head, class_of(head) or self.path.stem)
                    if kind == "function":
                        self.look(head, start, stack + [level], own, found)
                    stack.append(level)
                elif control:
                    # a loop's own condition is asked again and again
                    self.look(head, start, stack, own, found,
                              (control[1] or "").startswith(("for", "while"))
                              and not RANGE.match(head.strip()))
                    if control[2] == "else":
                        first, past = last.get(len(stack), (first, ""))
                        head = past + head
                    stack.append(("control", None, first, head, None))
                else:
                    self.look(head, start, stack, own, found)
                    stack.append(("block", None, first, head, None))
            else:
                if inside:
                    self.look(head, start, stack, own, found)
                if c == "}" and stack:
                    kind, _, first, past, _ = stack.pop()
                    if kind == "control":
                        last[len(stack)] = (first, past)
            start = at + 1
        return found

    def in_for(self, start, at):
        return re.match(r"\s*for\s*\(", self.code[start:at]) is not None

    def look(self, text, start, stack, own, found, looped=False):
        function = next(s for s in stack if s[0] == "function")
        for pattern in filter(None, (PRIMITIVE, own)):
            for m in pattern.finditer(text):
                call = re.sub(r"\s*\($", "", m[0])
                if pattern is own:
                    of = OBJECTS.get(m[1]) if m[1] else function[4]
                    # a name that stands for both is no sign
                    if (of, m[2]) not in self.known - self.both:
                        continue
                    # the head's own name
                    if m[2] == function[1] and text == function[3]:
                        continue
                # a member that is made, not called, or the head's own name
                if text == function[3] and (call.startswith("sumShared") or call == function[1]):
                    continue
                line = self.line(start + m.start())
                conditions = [(s[2], s[3]) for s in stack if s[0] == "control"]
                # of a constructor's list the member alone
                statement = re.split(r",\n    (?=\w)", text[:m.start()])[-1]
                if looped or re.search(r"\?|&&|\|\|", self.own_level(statement)):
                    conditions.append((start + len(text) - len(text.lstrip()), text))
                for first, head in conditions:
                    self.judge(call, line, first, head, found)
                if not self.says(function):
                    found.append((line, f"{function[1]} calls {call}: its comment does not say Collective"))

    def own_level(self, statement):
        return re.sub(r"&&\s*\w+\s*[,)]", "", statement)

    def judge(self, call, line, first, head, found):
        here = self.line(first)
        until = here + head.strip().count("\n")
        words = " ".join(self.notes.get(k, "") for k in range(here - 1, until + 1))
        words += above(self.notes, here)
        shown = re.sub(r"\s+", " ", head.strip())[:60]
        condition = re.sub(r"\s+", " ", re.sub(r"^(?:else )?(?:if|while|return)\b", "", head.strip()))
        condition = re.sub(r"^\((.*)\)$", r"\1", condition.strip()).strip()
        if re.match(r"for \(direction \w+ = 0; \w+ < (?:3|(?:vector|pTraits<Type>)::nComponents);", condition):
            return
        if all(ALIKE.fullmatch(term.strip()) for term in re.split(r"&&|\|\|", condition)):
            return
        if MARK not in words:
            found.append((line, f"{call} behind `{shown}`, of which no comment says `{MARK}`"))
        elif LOCAL.search(re.sub(r"returnReduce\s*\([^;]*?Op<\w+>\(\)\s*\)", "", head)):
            found.append((line, f"{call} behind `{shown}`, which is a rank's own"))

    def says(self, function):
        if {(function[4], function[1]), (self.path.stem, function[1])} & self.known:
            return True
        return COLLECTIVE.search(above(self.notes, self.line(function[2]))) is not None

    known = both = frozenset()


def check(sources):
    names, others = set(), set()
    for s in sources:
        declared = s.declared()
        names |= declared[0]
        others |= declared[1]
    for s in sources:
        s.known, s.both = names, names & others
    return [(s.path, line, text) for s in sources for line, text in s.violations(names)]


GOOD = """
//- Spreads. Collective.
void spread(volScalarField& f);

void A::spread(volScalarField& f)
{
    f.correctBoundaryConditions();
    // all ranks alike: from the dictionary
    if (active_)
    {
        smooth(f);
    }
}
"""
MODEL = """
class smoothingModel
{
    //- Smooths; collective
    void smooth(volScalarField& f) const;
};
"""
BAD = {
    "its comment does not say": GOOD.replace(" Collective.", ""),
    "of which no comment says": GOOD.replace("all ranks alike", "always"),
    "which is a rank's own": GOOD.replace("active_", "added.size()").replace("smooth(f)", "reduce(x, y)"),
    "behind `return": GOOD.replace("f.correctBoundaryConditions();",
                                   "return here && gSum(f) > 0;"),
    "behind `for": GOOD.replace("f.correctBoundaryConditions();",
                                "for (label i = 0; i < n; ++i) { reduce(x, y); }"),
    "behind `while": GOOD.replace("f.correctBoundaryConditions();",
                                  "while (gMax(f) > 0) { ++i; }"),
}


def test():
    """The contract's own examples: the good one passes, each bad one does not."""
    good = check([Source(Path("A.C"), GOOD.replace("smooth(f)", "reduce(x, y)"))])
    assert not good, good
    for words, text in BAD.items():
        said = check([Source(Path("A.C"), text.replace("smooth(f)", "reduce(x, y)"))])
        assert any(words in s[2] for s in said), (words, said)
    # through an object of another class, which is collective by its header
    header = Source(Path("smoothingModel.H"), MODEL)
    call = GOOD.replace("smooth(f)", "smoothing.smooth(f)").replace("active_", "added.size()")
    said = check([header, Source(Path("A.C"), call)])
    assert any("smoothing.smooth behind" in s[2] for s in said), said


def main(arguments):
    test()
    if arguments == ["--test"]:
        return 0
    folders = [Path(a) for a in arguments] or [Path(__file__).resolve().parent.parent]
    files = [f for folder in folders for f in sorted(folder.rglob("*.[CH]"))
             if "tests" not in f.parts and not f.stem.endswith(("Test", "Cost"))]
    if not files:
        print("collectives: no sources", file=sys.stderr)
        return 1
    found = check([Source(f, f.read_text()) for f in files])
    for path, line, text in found:
        print(f"{path}:{line}: {text}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
