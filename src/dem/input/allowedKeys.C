/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "allowedKeys.H"
#include "error.H"
#include "ListOps.H"

#include <vector>

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::label Foam::dem::editDistance
(
    const std::string& a,
    const std::string& b
)
{
    const label n = b.size();

    // Rows of the table of distances between the first i letters of a and
    // the first j letters of b
    std::vector<label> before(n + 1);
    std::vector<label> above(n + 1);
    std::vector<label> row(n + 1);

    for (label j = 0; j <= n; ++j)
    {
        above[j] = j;
    }

    for (label i = 1; i <= label(a.size()); ++i)
    {
        row[0] = i;
        for (label j = 1; j <= n; ++j)
        {
            const bool same = (a[i-1] == b[j-1]);

            row[j] = min(min(above[j], row[j-1]) + 1, above[j-1] + !same);

            if (i > 1 && j > 1 && a[i-1] == b[j-2] && a[i-2] == b[j-1])
            {
                row[j] = min(row[j], before[j-2] + 1);
            }
        }
        before.swap(above);
        above.swap(row);
    }

    return above[n];
}


Foam::word Foam::dem::nearestWord(const word& wrong, const wordList& allowed)
{
    // One slip in three letters still counts as near
    label least = max(label(1), label(wrong.size()/3)) + 1;
    word nearest;

    for (const word& candidate : allowed)
    {
        const label distance = editDistance(wrong, candidate);
        if (distance < least)
        {
            least = distance;
            nearest = candidate;
        }
    }

    return nearest;
}


std::string Foam::dem::listWords(const wordList& words)
{
    wordList sorted(words);
    sort(sorted);

    std::string text;
    for (const word& w : sorted)
    {
        text += (text.empty() ? "" : " ") + w;
    }
    return text;
}


void Foam::dem::checkKeys(const dictionary& dict, const wordList& allowed)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();

        if (!key.isPattern() && allowed.found(key))
        {
            continue;
        }

        const word nearest(nearestWord(key, allowed));

        OSstream& message = FatalIOError
        (
            FUNCTION_NAME,
            __FILE__,
            __LINE__,
            dict.name(),
            e.startLineNumber(),
            e.endLineNumber()
        );

        message << "Unknown keyword '" << key.c_str() << "' in dictionary "
            << dict.name();

        if (!nearest.empty())
        {
            message << "; did you mean '" << nearest << "'?";
        }

        message << nl << "Allowed keywords: " << listWords(allowed).c_str()
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
