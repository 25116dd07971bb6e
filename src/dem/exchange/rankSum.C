/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rankSum.H"
#include "Pstream.H"
#include "ops.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

template<class Type, class Operation>
void combine(Foam::List<Type>& values, const Operation& op)
{
    if (Foam::Pstream::parRun())
    {
        Foam::Pstream::listCombineGather(values, op);
        Foam::Pstream::listCombineScatter(values);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::dem::sumOverRanks(List<vector>& values)
{
    combine(values, plusEqOp<vector>());
}


void Foam::dem::sumOverRanks(List<scalar>& values)
{
    combine(values, plusEqOp<scalar>());
}


void Foam::dem::maxOverRanks(List<scalar>& values)
{
    combine(values, maxEqOp<scalar>());
}


void Foam::dem::anyOverRanks(boolList& flags)
{
    combine(flags, orEqOp<bool>());
}


// ************************************************************************* //
