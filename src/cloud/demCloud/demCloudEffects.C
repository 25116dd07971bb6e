/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "cloudState.H"
#include "earlyChoice.H"
#include "effectChoice.H"
#include "effectTable.H"
#include "sceneSurvey.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Add the entries of a dictionary that are not there, and those of its
//  dictionaries
void addMissing(Foam::dictionary& dict, const Foam::dictionary& more)
{
    for (const Foam::entry& e : more)
    {
        if (!dict.found(e.keyword()))
        {
            dict.add(e);
        }
        else if (e.isDict() && dict.isDict(e.keyword()))
        {
            addMissing(dict.subDict(e.keyword()), e.dict());
        }
    }
}

//- Are the bodies in a fluid that they may be coupled to?
bool takesFluid
(
    const Foam::dictionary& properties,
    const Foam::demCloud::fluidAccess access
)
{
    using namespace Foam;
    return
        access != demCloud::fluidAccess::none
     && properties.getOrDefault<word>("coupling", "") != "none";
}


//- Add what the solver of the bodies was made with at the first start
void resumeEarly(Foam::dictionary& properties, const Foam::fvMesh& mesh)
{
    using namespace Foam;
    const IOdictionary saved
    (
        cloudState::counters(mesh, IOobject::READ_IF_PRESENT)
    );
    const dictionary& effects = saved.subOrEmptyDict("effects");
    dictionary early;
    if (effects.found("sleeping"))
    {
        early.add("sleeping", effects.subDict("sleeping"));
    }
    for (const char* block : {"forces", "immersed"})
    {
        const dictionary& entries = effects.subOrEmptyDict(block);
        if (entries.found("lubrication"))
        {
            early.add(block, entries);
        }
    }
    addMissing(properties, early);
}


//- Does a field have the fluid's density? A film knows one liquid only
bool densityIsField(const Foam::dictionary& properties)
{
    const Foam::dictionary& fluid = properties.subOrEmptyDict("fluid");
    return
        fluid.found("rho") && fluid.lookup("rho").size()
     && fluid.lookup("rho")[0].isWord();
}


//- Say that a film is called for which cannot be
void adviseFilm
(
    const Foam::dictionary& properties,
    const Foam::fvMesh& mesh,
    const Foam::effectTable& table
)
{
    const Foam::string why = Foam::earlyChoice::noFilm(properties, mesh);
    if (table.on("lubrication") && why.size())
    {
        Foam::Info
            << "    Advice: lubrication is called for, and is left out, as "
            << why.c_str() << Foam::nl;
    }
}


//- Say that the mesh is not refined around bodies where it would save cells
void adviseMesh(const Foam::effectTable& table)
{
    bool refines = false;
    for (const Foam::sceneNumbers& n : table.kinds())
    {
        refines = refines || n.refines;
    }
    if (table.on("refinement") && table.on("immersed") && !refines)
    {
        Foam::Info
            << "    Advice: refinement is called for, as "
            << 100*table.share("refinement") << " % of the domain is far from"
            << " bodies; the mesh is the solver's: constant/dynamicMeshDict"
            << " with dynamicFvMesh dynamicRefineFvMesh." << Foam::nl;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::effectTable Foam::demCloud::judge
(
    const dem::demSolver& dem,
    const bool inFluid
) const
{
    effectTable table
    (
        sceneSurvey
        (
            mesh_,
            bins_,
            dem,
            inFluid ? sceneFluid(mesh_, dict_, &U()) : sceneFluid()
        ).numbers(),
        effects_.target
    );
    if (!inFluid && table.kinds().size())
    {
        earlyChoice::judgeRest(table, dict_, mesh_, dem.g());
    }
    return table;
}


void Foam::demCloud::chooseContacts(const fluidAccess access)
{
    if (!effects_.automatic)
    {
        return;
    }
    const wordList named(effectChoice::nameContacts(dict_));
    const bool restart = cloudState::found(mesh_);
    const bool inFluid = takesFluid(dict_, access);
    const bool film =
        inFluid && dict_.subOrEmptyDict("effects").found("roughness");
    const bool early =
        !restart && (film || (!inFluid && earlyChoice::mayRest(dict_)));
    if (named.size() || early)
    {
        // What attracts bodies follows from them, their laws from that; in a
        // restart from those of the first start, so that nothing changes
        dem::demInput input(solverInput(access));
        input.owner = nullptr;
        input.restart = false;
        const autoPtr<dem::demSolver> trial(dem::demSolver::New(input));
        effectChoice::dropContacts(dict_, named, judge(*trial, false));
        if (early)
        {
            chosen_ = earlyChoice::choose(dict_, judge(*trial, inFluid));
        }
    }
    if (restart)
    {
        resumeEarly(dict_, mesh_);
    }
}


void Foam::demCloud::chooseEffects
(
    const fluidAccess access,
    const bool restart
)
{
    if (!effects_.automatic)
    {
        return;
    }

    const wordList free(freeEffects(access));
    if (restart)
    {
        resumeEffects(access);
        startWatch(free, nullptr);
        return;
    }
    const bool byHand = dict_.found("coupling");
    const bool inFluid = takesFluid(dict_, access);
    const effectTable table(judge(*dem_, inFluid));
    Info<< "    effects auto, target error " << 100*table.target() << " %"
        << nl;
    table.writeNumbers(Info);
    table.write(Info);

    if (access == fluidAccess::share && !byHand)
    {
        // The equations have the void fraction
        dict_.add("coupling", word("twoWay"));
    }
    if (inFluid)
    {
        if (!effects_.namesFilm)
        {
            adviseFilm(dict_, mesh_, table);
        }
        adviseMesh(table);
        chosen_.merge
        (
            effectChoice::chooseCoupling
            (
                dict_,
                table,
                access == fluidAccess::act || access == fluidAccess::share,
                access == fluidAccess::share,
                mesh_.time().deltaTValue()
            )
        );
        coupling_ = dict_.get<word>("coupling");
    }
    chosen_.add("targetError", effects_.target);
    startWatch(free, &table);
}


Foam::wordList Foam::demCloud::freeEffects(const fluidAccess access) const
{
    DynamicList<word> names;
    if (access == fluidAccess::none)
    {
        return wordList();
    }
    const dictionary& forces = dict_.subOrEmptyDict("forces");
    for (const word& name : effectChoice::forces())
    {
        const bool other = name == "saffman" && forces.found("mei");
        if (!forces.found(name) && !other)
        {
            names.append(name);
        }
    }
    if (!forces.found("drag"))
    {
        names.append("drag");
        names.append("denseDrag");
    }
    if (!dict_.found("coupling") && access == fluidAccess::act)
    {
        names.append("exchange");
    }
    names.append("contacts");
    if (!effects_.namesFilm && !forces.found("coarseGraining"))
    {
        names.append("lubrication");
    }
    return wordList(std::move(names));
}


void Foam::demCloud::startWatch
(
    const wordList& names,
    const effectTable* table
)
{
    if (coupling_ == "none" || !dem_->moves())
    {
        return;
    }
    effectWatch_.reset(new effectWatch(effects_));
    const dictionary saved(chosen_.subOrEmptyDict("watch"));
    const bool points = pointBodies();
    const bool both = dict_.found("resolved");
    for (const word& name : names)
    {
        // Where there are both, the fluid feels all, and they may meet
        const bool stays =
            (
                both
             && (
                    name == "contacts" || name == "exchange"
                 || name == "lubrication"
                )
            )
         || (name == "dispersion" && !sceneFluid::turbulent(mesh_))
         || (
                name == "lubrication"
             && (densityIsField(dict_) || coupling_ == "particlesToFluid")
            );
        if ((points || name == "contacts") && !stays)
        {
            effectWatch_->add(name, table && table->on(name));
        }
    }
    if (!table)
    {
        effectWatch_->setState(saved);
    }
    if
    (
        effectWatch_->watches("lubrication")
     && earlyChoice::noFilm(dict_, mesh_).empty()
    )
    {
        // A roughness may have been given since it was called for
        const bool acts = dict_.subOrEmptyDict("forces").found("lubrication");
        if (effectWatch_->on("lubrication") != acts)
        {
            effectWatch_->add("lubrication", acts);
        }
    }
    if (effectWatch_->watches("contacts") && !effectWatch_->on("contacts"))
    {
        dem_->setMeets(false, true);
    }
}


void Foam::demCloud::resumeEffects(const fluidAccess access)
{
    const IOdictionary saved(cloudState::counters(mesh_, IOobject::MUST_READ));
    if (!saved.found("effects"))
    {
        FatalIOErrorInFunction(saved)
            << "effects auto has chosen nothing yet when this time was"
            << " written." << nl
            << "    Name the coupling and the forces, which styxAdvise -time "
            << mesh_.time().timeName() << " can say, or start anew."
            << exit(FatalIOError);
    }
    chosen_ = saved.subDict("effects");
    dictionary entries(chosen_);
    entries.remove("targetError");
    entries.remove("watch");
    addMissing(dict_, entries);
    if (access != fluidAccess::none)
    {
        coupling_ = dict_.get<word>("coupling");
    }
    Info<< "    effects auto goes on with the entries" << nl << entries;
}


// ************************************************************************* //
