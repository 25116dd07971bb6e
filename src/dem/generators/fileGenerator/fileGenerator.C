/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fileGenerator.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "IFstream.H"
#include "unitConversion.H"

#include <cmath>
#include <cstdlib>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(fileGenerator, 0);
    addToRunTimeSelectionTable(generator, fileGenerator, dictionary);
}
}


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

const Foam::wordList allowed
({
    "x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "ax", "ay", "az",
    "angle", "diameter", "shape", "material", "-"
});


Foam::DynamicList<Foam::word> wordsOf(Foam::string line)
{
    const auto comment = line.find('#');
    if (comment != std::string::npos)
    {
        line.resize(comment);
    }
    Foam::DynamicList<Foam::word> words;
    std::string::size_type begin, end = 0;
    const char* const between = " \t\r,;\"";
    while
    (
        (begin = line.find_first_not_of(between, end)) != std::string::npos
    )
    {
        end = line.find_first_of(between, begin);
        words.append
        (
            Foam::word(std::string(line, begin, end - begin), false)
        );
    }
    return words;
}


Foam::string listed(const Foam::UList<Foam::word>& words)
{
    Foam::string all;
    for (const Foam::word& w : words)
    {
        all += (all.empty() ? "" : " ") + w;
    }
    return all;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::fileGenerator::wrong
(
    const label line,
    const string& why
) const
{
    FatalErrorInFunction
        << "Generator " << name() << ": " << file_.c_str() << ", line " << line
        << ": " << why.c_str() << exit(FatalError);
}


bool Foam::dem::fileGenerator::names(const UList<word>& words)
{
    bool any = false;
    for (const word& w : words)
    {
        any = any || (w != "-" && allowed.found(w));
    }
    return any;
}


void Foam::dem::fileGenerator::checkColumns(const label line) const
{
    forAll(columns_, c)
    {
        if (!allowed.found(columns_[c]))
        {
            wrong
            (
                line,
                "a column is named " + columns_[c] + ", allowed are "
              + listed(allowed)
            );
        }
        if (columns_[c] != "-" && columns_.find(columns_[c]) != c)
        {
            wrong(line, "the column " + columns_[c] + " stands twice");
        }
    }

    // Those of a vector come together
    for
    (
        const wordList& set : List<wordList>
        ({
            {"x", "y", "z"}, {"vx", "vy", "vz"}, {"wx", "wy", "wz"},
            {"ax", "ay", "az", "angle"}
        })
    )
    {
        label n = 0;
        for (const word& w : set)
        {
            n += columns_.found(w);
        }
        if (n < set.size() && (n || set[0] == "x"))
        {
            wrong(line, "the columns must hold all of " + listed(set));
        }
    }
}


Foam::scalar Foam::dem::fileGenerator::number
(
    const UList<word>& words,
    const label column,
    const label line
) const
{
    char* end = nullptr;
    const scalar value = std::strtod(words[column].c_str(), &end);
    if (*end || !(mag(value) < 1e12))
    {
        wrong
        (
            line,
            "the column " + columns_[column] + " holds '" + words[column]
          + "', which is no number below 1e12"
        );
    }
    return value;
}


void Foam::dem::fileGenerator::readRow
(
    const UList<word>& words,
    const label line,
    const newBody& common,
    shapeSizes& shapes,
    const materials& m,
    const dictionary& dict
)
{
    if (words.size() != columns_.size())
    {
        wrong
        (
            line,
            "there are " + std::to_string(words.size()) + " words, but "
          + std::to_string(columns_.size()) + " columns: " + listed(columns_)
        );
    }

    newBody b(common);
    vector axis(Zero);
    scalar angle = 0, diameter = 0;
    forAll(words, c)
    {
        const word& what = columns_[c];
        const word& w = words[c];
        if (what == "shape")
        {
            b.shapeI = shapes.given().find(w);
            if (b.shapeI < 0)
            {
                wrong(line, "no shape " + w + ": " + listed(shapes.given()));
            }
        }
        else if (what == "material")
        {
            b.materialI = m.names().find(w);
            if (b.materialI < 0 || m.density(b.materialI) <= 0)
            {
                wrong
                (
                    line,
                    "no material " + w + " with a density: "
                  + listed(m.names())
                );
            }
        }
        else if (what != "-")
        {
            const scalar value = number(words, c, line);
            const direction d =
                what.back() == 'x' ? 0 : what.back() == 'y' ? 1 : 2;
            (
                what == "diameter" ? diameter
              : what == "angle" ? angle
              : what[0] == 'v' ? b.velocity[d]
              : what[0] == 'w' ? b.angularVelocity[d]
              : what[0] == 'a' ? axis[d]
              : b.position[d]
            ) = value;
        }
    }

    b.position *= scale_;
    b.density = m.density(b.materialI);
    if (columns_.found("diameter"))
    {
        if (diameter*scale_ < 1e-12)
        {
            wrong(line, "the diameter is not above 1e-12 m");
        }
        b.shapeI = shapes.ofSize(b.shapeI, diameter*scale_, dict);
    }
    if (angle != 0)
    {
        if (mag(axis) < SMALL)
        {
            wrong(line, "the axis has no length");
        }
        b.orientation = quaternion(axis, degToRad(angle));
    }
    rows_.append(b);
    lines_.append(line);
}


void Foam::dem::fileGenerator::readFile
(
    const newBody& common,
    shapeSizes& shapes,
    const materials& m,
    const dictionary& dict
)
{
    IFstream is(file_);
    if (!is.good())
    {
        badEntry(dict, "file", "cannot be read: " + file_);
    }

    label line = 0;
    string text;
    while (is.getLine(text).good() || !text.empty())
    {
        ++line;
        const DynamicList<word> words(wordsOf(text));
        text.clear();
        if (words.empty())
        {
            continue;
        }
        if (columns_.empty())
        {
            const bool named = names(words);
            columns_ = named ? wordList(words) : wordList({"x", "y", "z"});
            checkColumns(line);
            if (named)
            {
                continue;
            }
        }
        readRow(words, line, common, shapes, m, dict);
    }
    if (rows_.empty())
    {
        badEntry(dict, "file", "holds no body: " + file_);
    }
    total_ = rows_.size();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::fileGenerator::fileGenerator
(
    const word& name,
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m,
    const fileName& directory
)
:
    generator(name),
    file_(dict.get<fileName>("file")),
    columns_(dict.getOrDefault<wordList>("columns", wordList())),
    scale_(getPositive(dict, "scale", 1)),
    start_(getFinite(dict, "start", 0))
{
    checkKeys
    (
        dict,
        {"type", "file", "columns", "shape", "material", "scale", "start"}
    );
    if (!file_.isAbsolute())
    {
        file_ = directory/file_;
    }
    if (columns_.size())
    {
        checkColumns(0);
    }

    // What no column says
    newBody common{};
    if (dict.found("shape"))
    {
        common.shapeI = shapes.find(dict, "shape");
    }
    if (dict.found("material"))
    {
        common.materialI = m.findOfBody(dict, "material");
    }
    readFile(common, shapes, m, dict);
    for (const char* const key : {"shape", "material"})
    {
        if (columns_.found(key) == dict.found(key))
        {
            badEntry
            (
                dict,
                key,
                columns_.found(key)
              ? "is a column of the file, too"
              : "is missing: neither here nor a column of the file"
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::generatorPlan Foam::dem::fileGenerator::plan() const
{
    generatorPlan plan;
    plan.name = name();
    plan.total = total_;
    for (const newBody& b : rows_)
    {
        plan.speed = max(plan.speed, mag(b.velocity));
        if
        (
            plan.parts.empty()
         || plan.parts.last().shapeI != b.shapeI
         || plan.parts.last().materialI != b.materialI
        )
        {
            plan.parts.append
            (
                generatorPlan::part{b.shapeI, b.materialI, 0}
            );
        }
        ++plan.parts.last().number;
    }
    return plan;
}


Foam::label Foam::dem::fileGenerator::nDue(const scalar t)
{
    return t < start_ - 1e-9*mag(start_) ? 0 : total_;
}


void Foam::dem::fileGenerator::release()
{
    if (nEntered() >= total_)
    {
        rows_.clearStorage();
        lines_.clearStorage();
    }
}


bool Foam::dem::fileGenerator::make
(
    const label n,
    const hasRoom& room,
    newBody& body
) const
{
    body = rows_[n];
    return room(body);
}


Foam::string Foam::dem::fileGenerator::source(const label n) const
{
    return file_ + ", line " + std::to_string(lines_[n]);
}


// ************************************************************************* //
