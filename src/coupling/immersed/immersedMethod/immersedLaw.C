/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "immersedMethod.H"
#include "readAhead.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::immersedMethod::edge(const label cell) const
{
    const scalar V = mesh_.V()[cell];
    return thickness_ > 0 ? sqrt(V/thickness_) : cbrt(V);
}


Foam::scalar Foam::coupling::immersedMethod::tightFraction
(
    const bodyGeometry& body,
    const bodyCell& bc
) const
{
    // A cell deep below the surface that is nearest: nearer to one that looks
    // the other way?
    const scalar h = edge(bc.cell);
    const point deep = mesh_.cellCentres()[bc.cell] - (bc.phi + h)*bc.n;
    const scalar phi = body.distance(deep);
    if (phi < -(1 - 1e-6)*h || (body.normal(deep) & bc.n) > -0.5)
    {
        return bc.beta;
    }

    // The body's thickness is h - phi. In one of the cells across it there is
    // half of it, and that is to be all
    return min(2*bc.beta*h/max(h - phi, bc.beta*h), scalar(1));
}


void Foam::coupling::immersedMethod::findLinks
(
    const bodyGeometry& body,
    bodyCell& bc
)
{
    bc.link = links_.size();

    for (const label f : mesh_.cells()[bc.cell])
    {
        vector d;
        if (!sides_.across(f, bc.cell, d))
        {
            continue;
        }
        const scalar inside = body.distance(mesh_.cellCentres()[bc.cell] + d);
        if (inside >= 0)
        {
            continue;
        }

        // How far the surface is on the way to the centre inside. Where it is
        // next to nothing the cell has the body's velocity
        const scalar theta = max(bc.phi/(bc.phi - inside), 1e-6);
        const scalar g = sides_.conductance(f)/mesh_.V()[bc.cell];
        links_.append(wallLink{f, g, theta, bc.r + d});
    }
    bc.nLinks = links_.size() - bc.link;
}


void Foam::coupling::immersedMethod::addNeighbours
(
    const label b,
    const vector& shift,
    const scalar reach
)
{
    const dem::bodies& state = present_();
    const bodyGeometry body(state, b, solved_, shift);
    const point centre = state.x[b] + shift;

    // Those of this image are there already
    const label stamp = ++stamp_;
    for (const bodyCell& bc : cells_[b])
    {
        if (mag(mesh_.cellCentres()[bc.cell] - bc.r - centre) < 1e-3*reach)
        {
            found_[bc.cell] = stamp;
        }
    }

    DynamicList<label> near(1024);
    bins_.forEach
    (
        centre,
        state.shapeOf(b).fluidRadius() + reach,
        [&](const label c)
        {
            const scalar far = reach + bins_.radius(c);
            if
            (
                found_[c] != stamp
             && body.distance(mesh_.cellCentres()[c]) <= far
            )
            {
                near.append(c);
            }
        }
    );

    forAll(near, k)
    {
        readAhead::faces(mesh_, near, k);
        const label c = near[k];
        bodyCell bc{c, 0, mesh_.cellCentres()[c] - centre};
        bc.phi = body.distance(mesh_.cellCentres()[c]);
        bc.rho = rho_[c];
        findLinks(body, bc);
        if (bc.nLinks)
        {
            cells_[b].append(bc);
        }
    }
}


void Foam::coupling::immersedMethod::findFriction()
{
    const dem::bodies& state = present_();

    // A cell beside one whose centre is inside is no farther from it than
    // that one reaches, on whichever rank it is
    List<scalar> reach(cells_.size(), scalar(0));
    forAll(cells_, b)
    {
        for (const bodyCell& bc : cells_[b])
        {
            if (bc.beta >= 1 || bc.phi < 0)
            {
                reach[b] = max(reach[b], bins_.radius(bc.cell));
            }
        }
    }
    present_.max(reach);

    links_.clear();
    found_.setSize(mesh_.nCells());
    found_ = 0;
    stamp_ = 0;
    forAll(cells_, b)
    {
        if (!kinds_.resolved(b))
        {
            continue;
        }
        for (bodyCell& bc : cells_[b])
        {
            if (bc.beta < 1 && bc.phi >= 0)
            {
                const vector shift =
                    mesh_.cellCentres()[bc.cell] - bc.r - state.x[b];
                const bodyGeometry body(state, b, solved_, shift);
                findLinks(body, bc);
            }
        }
        addNeighbours(b, Zero, reach[b]);
        dem_.period().forEachImage
        (
            state.x[b],
            state.shapeOf(b).fluidRadius() + 2*reach[b],
            [&](const label image)
            {
                addNeighbours(b, dem_.period().shift(image), reach[b]);
            }
        );
    }
}


void Foam::coupling::immersedMethod::setLaw
(
    const label b,
    bodyCell& bc,
    const knownFlow& flow
) const
{
    if (bc.beta < 1)
    {
        setCut(b, bc, flow);
        return;
    }
    bc.target = imposed_[b].at(bc.r);
    bc.K = kappa_/mesh_.time().deltaTValue();
}


void Foam::coupling::immersedMethod::setCut
(
    const label b,
    bodyCell& bc,
    const knownFlow& flow
) const
{
    const scalar dt = mesh_.time().deltaTValue();
    const vector Ub = imposed_[b].at(bc.r);

    // The friction of the wall in place of that against the cells inside,
    // which may slip
    scalar Kv = 0;
    bc.push = Zero;
    if (bc.phi < 0)
    {
        Kv =
            bc.beta/max(1 - bc.beta, SMALL)
           *viscousRate_*flow.nu.inCell(bc.cell)/sqr(edge(bc.cell));
    }
    for (label k = bc.link; k < bc.link + bc.nLinks; ++k)
    {
        const wallLink& l = links_[k];
        const scalar nug = flow.nu(l.face, bc.cell)*l.g;
        Kv += nug*(1/l.theta - 1);
        bc.push +=
            nug*(imposed_[b].at(l.r) - flow.across(l.face, bc.cell));
    }

    // The mixture: tight across the surface, free along it
    const imposedMotion& old = imposed0_[present_().id[b]];
    const vector& Un = flow.U.oldTime()[bc.cell];
    const vector dUb = Ub - old.at(bc.r);
    const auto across = [&](const vector& along)
    {
        return along + ((Ub - along) & bc.n)*bc.n;
    };
    const scalar Ki = min(bc.beta/max(1 - bc.beta, SMALL), kappa_)/dt;

    // What is tighter than its share has no more than that share of the body's
    // inertia along the surface
    const scalar Kt =
        min(bc.tight/max(1 - bc.tight, SMALL), kappa_)/dt - Ki;

    const scalar K = Kv + Ki + Kt;
    bc.target =
        (Kv*Ub + Ki*across(Un + dUb) + Kt*across(Un + bc.beta*dUb))
       /max(K, VSMALL);
    bc.K = min(K, kappa_/dt);
}


// ************************************************************************* //
