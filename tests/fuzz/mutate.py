#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Spoils inputs, each time one to three things:
#         text, mustReject = dictionary(text, random)
#         data = surface(data, random)
#         data = savedFile(data, random)
#     All randomness comes from the random.Random that is handed over.
#     mustReject says why a run must not accept the dictionary, or is None when
#     it may.
#------------------------------------------------------------------------------
import re

NUMBERS = ["nan", "-nan", "inf", "-inf", "0", "-0", "-1", "1", "0.5", "1e300",
           "-1e300", "1e-300", "1e400", "1e9", "1e-9", "2147483647",
           "2147483648", "-2147483648", "99999999999999999999", "1e", "0x10",
           "1.2.3", "1,5"]
WORDS = ["", "none", "yes", "off", "7", "(0 0 1)", "{ }", "()", "((", "word",
         "\"a string\"", "sphere", "hades", "constant", "$missing", "../x",
         "a b", "#nothing", "[0 1 -1 0 0 0 0]", "\"", "/*", "*/", "//",
         "\x00", "\xff\xfe"]
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")
TOKEN = re.compile(r"[{}();]|\"[^\"]*\"|[^\s{}();\"]+")

# Numbers that have no meaning at or below zero, wherever they stand
POSITIVE = {"density", "youngsModulus", "diameter", "rho", "rate", "kappa",
            "viscousRate", "deltaT", "minDeltaT", "maxDeltaT", "skin"}
NON_NEGATIVE = {"friction", "normalDamping", "tangentialDamping", "layer",
                "poissonsRatio", "restitution", "total", "seed"}


def body(text):
    """Where the entries begin: after the head."""
    match = re.search(r"FoamFile\s*\{[^}]*\}", text)
    return match.end() if match else 0


def withoutComments(text):
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    return re.sub(r"//[^\n]*", " ", text)


def reasonToReject(text):
    """Why a dictionary cannot be right, judged by its words alone."""
    if "/*" in re.sub(r"/\*.*?\*/", " ", re.sub(r"//[^\n]*", " ", text),
                      flags=re.S):
        return "comment without an end"
    plain = withoutComments(text)
    if plain.count("\"") % 2:
        return None
    plain = re.sub(r"\"[^\"]*\"", "string", plain)
    depth, stack = 0, []
    for c in plain:
        if c in "({":
            stack.append(c)
        elif c in ")}":
            if not stack or stack.pop() != ("(" if c == ")" else "{"):
                return "brackets that do not match"
    if stack:
        return "brackets that do not match"
    words = TOKEN.findall(plain)
    for before, word, after in zip([""] + words, words, words[1:] + [""]):
        if re.fullmatch(r"[-+]?(nan|inf)", word, re.I) and after != "{":
            return "the number " + word
        if before in POSITIVE | NON_NEGATIVE and NUMBER.match(word):
            value = float(word)
            if value < 0 or (value == 0 and before in POSITIVE):
                return before + " " + word
    return None


def edited(tokens, random):
    """One change in a list of (text, gap before)."""
    i = random.randrange(len(tokens))
    text, gap = tokens[i]
    isNumber = NUMBER.match(text)
    choice = random.random()
    if isNumber and choice < 0.6:
        if random.random() < 0.3:
            new = "%g" % (float(text)*random.choice(
                (-1, 10, 0.1, 1e6, 1e-6, 1e12, 1e-12)))
        else:
            new = random.choice(NUMBERS)
        tokens[i] = (new, gap)
    elif choice < 0.30:
        del tokens[i]
    elif choice < 0.45:
        tokens.insert(i, (text, gap))
    elif choice < 0.60:
        j = random.randrange(len(tokens))
        tokens[i], tokens[j] = (tokens[j][0], gap), (text, tokens[j][1])
    elif choice < 0.80:
        tokens[i] = (random.choice(WORDS + NUMBERS), gap)
    elif choice < 0.88 and len(text) > 1:
        k = random.randrange(len(text))
        how = random.randrange(3)
        tokens[i] = (text[:k] + ("", "x", text[k]*2)[how] + text[k + 1:], gap)
    elif choice < 0.94:
        tokens.insert(i, (random.choice("{}();"), " "))
    else:
        j = min(len(tokens), i + random.randrange(1, 20))
        if random.random() < 0.5:
            del tokens[i:j]
        else:
            tokens[j:j] = tokens[i:j]
    if not tokens:
        tokens.append((";", " "))


def dictionary(text, random):
    start = 0 if random.random() < 0.05 else body(text)
    head, rest = text[:start], withoutComments(text[start:])
    tokens, end = [], 0
    for match in TOKEN.finditer(rest):
        tokens.append((match.group(), rest[end:match.start()] or ""))
        end = match.end()
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        edited(tokens, random)
    new = head + "".join(
        (gap or (" " if random.random() < 0.98 else "")) + word
        for word, gap in tokens) + "\n"
    if random.random() < 0.03:
        new = new[:random.randrange(len(new))]
    return new.encode("latin-1", "replace"), reasonToReject(new)


def flipped(data, random, n):
    data = bytearray(data)
    for _ in range(n):
        if data:
            data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    return bytes(data)


def surface(data, random):
    choice = random.random()
    isText = b"vertex" in data or b"\nv " in data
    if choice < 0.15:
        return data[:random.randrange(len(data))]
    if choice < 0.35:
        return flipped(data, random, random.choice((1, 2, 8, 64)))
    if not isText or choice < 0.45:
        i = random.randrange(len(data))
        j = min(len(data), i + random.randrange(1, 200))
        how = random.randrange(3)
        return data[:i] + (b"", data[i:j]*2, random.randbytes(j - i))[how] \
            + data[j:]

    lines = data.decode("latin-1").split("\n")
    for _ in range(random.choice((1, 1, 2, 5))):
        i = random.randrange(len(lines))
        words = lines[i].split()
        how = random.random()
        if how < 0.2:
            del lines[i]
        elif how < 0.35:
            lines.insert(i, lines[i])
        elif how < 0.5:
            j = random.randrange(len(lines))
            lines[i], lines[j] = lines[j], lines[i]
        elif words:
            k = random.randrange(len(words))
            words[k] = random.choice(
                NUMBERS + WORDS + [w for w in words if w])
            lines[i] = " ".join(words)
        if not lines:
            lines.append("")
    return "\n".join(lines).encode("latin-1", "replace")


def savedFile(data, random):
    choice = random.random()
    if choice < 0.15:
        return data[:random.randrange(len(data) + 1)]
    if choice < 0.50:
        return flipped(data, random, random.choice((1, 1, 1, 2, 16)))
    if choice < 0.60:
        i = random.randrange(len(data) + 1)
        return data[:i] + random.randbytes(random.randrange(1, 9)) + data[i:]
    if choice < 0.70:
        i = random.randrange(len(data))
        return data[:i] + data[i + random.randrange(1, 40):]
    # A number in the text, counts above all
    numbers = list(re.finditer(rb"(?<![\w.])-?\d+(\.\d+)?(e-?\d+)?(?![\w.])",
                               data))
    if not numbers:
        return flipped(data, random, 1)
    match = numbers[min(random.randrange(len(numbers)),
                        random.randrange(len(numbers)))]
    new = random.choice(NUMBERS + [str(random.randrange(100))])
    return data[:match.start()] + new.encode() + data[match.end():]
