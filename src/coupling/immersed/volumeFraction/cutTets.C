/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cutTets.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef Foam::coupling::cutTets::rows rows;

// The volume inside of the first n tetrahedra, row by row into V [m3]. One
// such function is compiled for each width of vectors
__attribute__((target_clones("avx512f", "avx2", "default")))
void cutAll(rows& t, const int n, const Foam::vector& directions)
{
    const double solved[3] = {directions[0], directions[1], directions[2]};
    for (int k = 0; k < n; ++k)
    {
        double mean[3], r[3], d2[4], dr[4];
        double r2 = 1e-300;
        for (int i = 0; i < 3; ++i)
        {
            mean[i] = 0;
            for (int c = 0; c < 4; ++c)
            {
                mean[i] += 0.25*t.x[c][i][k];
            }
            r[i] = solved[i]*(mean[i] - t.centre[i][k]);
            r2 += r[i]*r[i];
        }
        for (int c = 0; c < 4; ++c)
        {
            d2[c] = 0;
            dr[c] = 0;
            for (int i = 0; i < 3; ++i)
            {
                const double d = solved[i]*(t.x[c][i][k] - mean[i]);
                d2[c] += d*d;
                dr[c] += d*r[i];
            }
        }

        // The mean of the linear function is that of the curved one
        double bulge = 0;
        for (int c = 0; c < 4; ++c)
        {
            bulge += d2[c] - dr[c]*dr[c]/r2;
        }
        bulge *= 0.1/std::sqrt(r2);

        t.V[k] *= Foam::coupling::cutTets::negativeFraction
        (
            t.phi[0][k] - bulge,
            t.phi[1][k] - bulge,
            t.phi[2][k] - bulge,
            t.phi[3][k] - bulge
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::cutTets::empty()
{
    cutAll(rows_, n_, solved_);
    for (int k = 0; k < n_; ++k)
    {
        sum_ += rows_.V[k];
    }
    n_ = 0;
}


// ************************************************************************* //
