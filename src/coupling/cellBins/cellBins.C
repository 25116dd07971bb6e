/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cellBins.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelVector Foam::coupling::cellBins::binOf(const point& p) const
{
    labelVector b;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar x = std::floor((p[d] - origin_[d])/width_[d]);
        b[d] = label(min(max(x, scalar(0)), scalar(n_[d] - 1)));
    }
    return b;
}


void Foam::coupling::cellBins::findRadii()
{
    const pointField& points = mesh_.points();
    const pointField& cc = mesh_.cellCentres();
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    radius_.setSize(mesh_.nCells());
    radius_ = 0;

    forAll(mesh_.faces(), f)
    {
        const label o = owner[f];
        const label n = f < neighbour.size() ? neighbour[f] : o;
        for (const label p : mesh_.faces()[f])
        {
            radius_[o] = max(radius_[o], magSqr(points[p] - cc[o]));
            radius_[n] = max(radius_[n], magSqr(points[p] - cc[n]));
        }
    }

    radius_ = sqrt(radius_);
    maxRadius_ = radius_.size() ? max(radius_) : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::cellBins::cellBins(const polyMesh& mesh)
:
    mesh_(mesh),
    tree_(mesh)
{
    update();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::cellBins::update()
{
    ++version_;
    findRadii();
    tree_.clear();
    nSought_ = 0;

    const pointField& cc = mesh_.cellCentres();
    const label nCells = cc.size();

    boundBox box(cc, false);
    if (!nCells)
    {
        box = boundBox(Zero, Zero);
    }

    // Cubes, as many as there are cells if those fill the box
    const vector size = box.span() + vector::one*max(box.mag()*1e-6, VSMALL);
    const scalar edge =
        cbrt(cmptProduct(max(size, vector::one*maxRadius_))/max(nCells, 1));

    origin_ = box.min();
    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = label(min(max(size[d]/edge, scalar(1)), scalar(1000)));
        width_[d] = size[d]/n_[d];
    }

    // Counting sort
    labelList bin(nCells);
    start_.setSize(n_.x()*n_.y()*n_.z() + 1);
    start_ = 0;
    forAll(cc, c)
    {
        bin[c] = index(binOf(cc[c]));
        ++start_[bin[c] + 1];
    }
    for (label b = 1; b < start_.size(); ++b)
    {
        start_[b] += start_[b - 1];
    }

    labelList next(start_);
    cells_.setSize(nCells);
    forAll(cc, c)
    {
        cells_[next[bin[c]]++] = c;
    }
}


Foam::scalar Foam::coupling::cellBins::outside
(
    const point& p,
    const label cell
) const
{
    scalar worst = -GREAT;
    for (const label f : mesh_.cells()[cell])
    {
        const vector& S = mesh_.faceAreas()[f];
        const scalar d =
            ((p - mesh_.faceCentres()[f]) & S)/max(mag(S), VSMALL);
        worst = max(worst, mesh_.faceOwner()[f] == cell ? d : -d);
    }
    return worst/radius_[cell];
}


Foam::scalar Foam::coupling::cellBins::depth
(
    const point& p,
    const label cell
) const
{
    if (cell < 0 || cell >= mesh_.nCells())
    {
        return -1;
    }
    scalar least = GREAT;
    for (const label f : mesh_.cells()[cell])
    {
        const vector& S = mesh_.faceAreas()[f];
        const scalar d = (p - mesh_.faceCentres()[f]) & S;
        if ((d > 0) == (mesh_.faceOwner()[f] == cell))
        {
            return -1;
        }
        least = min(least, d*d/max(magSqr(S), VSMALL));
    }
    return std::sqrt(least) - 2*roundOff*radius_[cell];
}


bool Foam::coupling::cellBins::wellInside
(
    const point& p,
    const label cell
) const
{
    // Without a root or a division, as this is asked most
    const scalar margin = sqr(roundOff*radius_[cell]);
    for (const label f : mesh_.cells()[cell])
    {
        const vector& S = mesh_.faceAreas()[f];
        const scalar d = (p - mesh_.faceCentres()[f]) & S;
        if
        (
            (d > 0) == (mesh_.faceOwner()[f] == cell)
         || d*d < margin*magSqr(S)
        )
        {
            return false;
        }
    }
    return true;
}


Foam::label Foam::coupling::cellBins::walk
(
    const point& p,
    const label start
) const
{
    label c = start;
    for (label step = 0; step < 32; ++step)
    {
        if (wellInside(p, c))
        {
            return c;
        }

        label through = -1;
        scalar worst = -GREAT;
        for (const label f : mesh_.cells()[c])
        {
            const vector& S = mesh_.faceAreas()[f];
            const scalar d =
                ((p - mesh_.faceCentres()[f]) & S)/max(mag(S), VSMALL)
               *(mesh_.faceOwner()[f] == c ? 1 : -1);
            if (d > worst)
            {
                worst = d;
                through = f;
            }
        }

        if (mag(worst) < roundOff*radius_[c])
        {
            return -1;
        }
        if (worst < 0)
        {
            return c;
        }
        if (!mesh_.isInternalFace(through))
        {
            return -1;
        }
        const label owner = mesh_.faceOwner()[through];
        c = owner == c ? mesh_.faceNeighbour()[through] : owner;
    }
    return -1;
}


Foam::label Foam::coupling::cellBins::find
(
    const point& p,
    const label near
) const
{
    if (near >= 0 && near < mesh_.nCells())
    {
        const label c = walk(p, near);
        if (c >= 0)
        {
            return c;
        }
    }

    // The cell that p is deepest in. On a face, an edge or a vertex several
    // cells are as good: round-off must not make it none, nor choose. (The
    // decomposition
    // by face diagonals is made by all ranks together on first use: here, where
    // one rank may come alone, it would wait for ever.)
    // A vertex is as far from the centre as the cell's radius, but for
    // round-off, hence the small ball.
    const pointField& cc = mesh_.cellCentres();
    label found = -1;
    scalar least = GREAT;
    const scalar ball = roundOff*maxRadius_;

    // How well it is found: not, by the decomposition, on a face, inside
    label best = 0;
    const auto compare = [&](const label c)
    {
        if (magSqr(cc[c] - p) > sqr(ball + radius_[c]))
        {
            return;
        }
        const scalar d = outside(p, c);
        const label kind =
            d <= -roundOff
          ? 3
          : d < roundOff
          ? 2
          : best < 2
         && d < least
         && mesh_.pointInCell(p, c, polyMesh::FACE_CENTRE_TRIS)
          ? 1
          : 0;
        if
        (
            kind > best
         || kind == 1
         || (kind == 3 && d < least)
         || (kind == 2 && best == 2 && claim(c) > claim(found))
        )
        {
            found = c;
            best = kind;
            least = d;
        }
    };

    // To make the tree pays when many are sought
    if (100*++nSought_ < mesh_.nCells())
    {
        forEach(p, 2*ball, compare);
    }
    else
    {
        tree_.forEach(p, compare);
    }
    return found;
}


Foam::label Foam::coupling::cellBins::nearest
(
    const point& p,
    const scalar within
) const
{
    const pointField& cc = mesh_.cellCentres();

    label best = -1;
    forEach
    (
        p,
        within,
        [&](const label c)
        {
            if (best < 0 || magSqr(cc[c] - p) < magSqr(cc[best] - p))
            {
                best = c;
            }
        }
    );
    return best;
}


// ************************************************************************* //
