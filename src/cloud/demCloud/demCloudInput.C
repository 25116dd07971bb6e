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
#include "couplingAccuracy.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "dictionaryText.H"
#include "dynamicRefineFvMesh.H"
#include "fvcFlux.H"
#include "lubrication.H"
#include "OSspecific.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- The file of the particles, which must be there
Foam::IOobject propertiesFile(const Foam::fvMesh& mesh)
{
    using namespace Foam;

    const IOobject io
    (
        "demCloudProperties",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    if (!IOobject(io).typeHeaderOk<IOdictionary>(true))
    {
        FatalErrorInFunction
            << "No dictionary " << io.objectPath() << "." << nl
            << "    It says what the particles are; write it (see"
            << " doc/dictionaries/demCloudProperties.md) or take the entry"
            << " of type demCloud out of constant/fvOptions."
            << exit(FatalError);
    }

    const fileName text(io.globalFilePath(IOdictionary::typeName));
    if (isFile(text, false))
    {
        dem::checkText(text);
    }
    return io;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demCloud::checkInput() const
{
    dem::checkKeys
    (
        dict_,
        {
            "coupling", "demSolver", "fluid", "materials", "pairs", "shapes",
            "bodies", "generators", "sinks", "meters", "contact", "walls",
            "integrator", "stepControl", "neighbours", "immersed", "forces",
            "voidFraction", "momentumExchange", "solidFields", "interface",
            "couplingInterval", "output", "start", "effects",
            "watchdog", "resolved", "accuracy", "sleeping"
        }
    );
}


Foam::vector Foam::demCloud::readGravity() const
{
    IOobject io
    (
        "g",
        mesh_.time().constant(),
        mesh_.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        Info<< "    no file constant/g: no gravity" << endl;
        return Zero;
    }
    return uniformDimensionedVectorField(io).value();
}


Foam::dem::demInput Foam::demCloud::solverInput(const fluidAccess access)
{
    dem::demInput input(dict_);
    input.directory =
        mesh_.time().rootPath()/mesh_.time().globalCaseName()
       /mesh_.time().constant();
    input.g = readGravity();
    input.closed = mesh_.bounds();
    input.meshMoves = mesh_.dynamic() && !isA<dynamicRefineFvMesh>(mesh_);
    if (accuracy_.valid())
    {
        couplingAccuracy::chooseSleeping(dict_, *accuracy_, mag(input.g));
    }
    input.start = mesh_.time().value();
    input.period = patches_.period();
    input.patchTriangles =
        [this](const wordRes& names, const dictionary& d, const bool old)
        {
            return patches_.triangles(patches_.walls(names, d), old);
        };
    input.mirrors = patches_.mirrors();
    input.mirrorTriangles =
        [this](const word& name, const bool old)
        {
            const label p = mesh_.boundaryMesh().findPatchID(name);
            return patches_.triangles(labelList(1, p), old);
        };
    input.outlets = exits_.outlets();
    const dictionary& forces = dict_.subOrEmptyDict("forces");
    if
    (
        access != fluidAccess::none
     && (pointBodies() || (effects_.automatic && !dict_.found("coupling")))
     && coupling::lubrication::switchedOn(forces)
    )
    {
        input.film = coupling::lubrication::read
        (
            mesh_,
            dict_.subDict("fluid"),
            forces
        );
    }
    const dictionary& solids = dict_.subOrEmptyDict("immersed");
    if
    (
        (immersedBodies() || (effects_.automatic && !dict_.found("coupling")))
     && solids.found(coupling::lubrication::name)
    )
    {
        if (input.film.acts())
        {
            dem::badEntry
            (
                solids,
                coupling::lubrication::name,
                "stands in forces, too, and there is one film between bodies"
                " of any kind; take one of them out"
            );
        }
        input.film = coupling::lubrication::belowGrid
        (
            mesh_,
            dict_.subDict("fluid"),
            solids
        );
    }
    setOwner(access, input);
    input.mayReorder = !immersedBodies();
    input.restart = cloudState::found(mesh_);
    input.contactError = accuracy_.valid() ? accuracy_->share() : 0;
    input.checkShape =
        [this](const dem::shape& s, const dictionary& d)
        {
            checkSize(s, d);
        };
    input.save = [this]() { saveState(); };
    return input;
}


void Foam::demCloud::readOutput()
{
    if (!dict_.found("output"))
    {
        return;
    }
    const dictionary& output = dict_.subDict("output");
    dem::checkKeys(output, {"vtp", "contactNetwork", "forces"});
    vtp_ = output.getOrDefault<bool>("vtp", false);
    network_ = output.getOrDefault<bool>("contactNetwork", false);
    if (!output.getOrDefault<bool>("forces", false))
    {
        return;
    }
    if (!immersed_.valid())
    {
        dem::badEntry
        (
            output,
            "forces",
            "writes the forces on resolved bodies, which need the block"
            " immersed; those on points are in lagrangian/demCloud"
        );
    }
    dem_->tellFilms();
    const Time& time = mesh_.time();
    forces_.reset
    (
        new forceTable
        (
            time.rootPath()/time.globalCaseName()/"postProcessing/demCloud"
           /time.timeName()
        )
    );
}


void Foam::demCloud::checkSize
(
    const dem::shape& s,
    const dictionary& dict
) const
{
    const scalar domain = mesh_.bounds().mag();
    if (2*s.boundingRadius() > domain)
    {
        FatalIOErrorInFunction(dict)
            << "The shape " << s.name() << " measures "
            << 2*s.boundingRadius() << " m, the whole domain "
            << domain << " m." << nl
            << "    Is the shape given in other units than the mesh?"
            << exit(FatalIOError);
    }
    if (!s.surface() || mesh_.nSolutionD() > 2)
    {
        return;
    }

    // The fluid sees the section in the middle: the ends must be far
    const pointField& own = s.surface()->surface().surface().localPoints();
    const vector span = boundBox((own & s.toUser().T()), false).span();
    scalar along = 0, across = 0;
    for (direction d = 0; d < 3; ++d)
    {
        scalar& extent = mesh_.solutionD()[d] > 0 ? across : along;
        extent = max(extent, span[d]);
    }
    if (along < across)
    {
        dem::badEntry
        (
            dict,
            "surface",
            "is a prism of length " + Foam::name(along) + " m in the"
            " direction that the mesh does not solve for, and as wide as "
          + Foam::name(across) + " m: make it as long as it is wide, or longer"
        );
    }
}


void Foam::demCloud::refineInitially(const bool restarted)
{
    if (!interface_.valid())
    {
        return;
    }

    markInterface();

    dynamicRefineFvMesh* mesh =
        dynamic_cast<dynamicRefineFvMesh*>(const_cast<fvMesh*>(&mesh_));
    if (!mesh)
    {
        return;
    }

    const IOdictionary meshDict
    (
        IOobject
        (
            "dynamicMeshDict",
            mesh_.time().constant(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const dictionary& coeffs =
        meshDict.optionalSubDict("dynamicRefineFvMeshCoeffs");
    interface_->checkLevels(coeffs);
    if (restarted || mesh_.time().timeIndex() != 0)
    {
        return;
    }

    const label interval = coeffs.get<label>("refineInterval");
    const label levels = coeffs.get<label>("maxRefinement");

    // The mesh refines only in steps whose number its interval divides
    Time& time = const_cast<Time&>(mesh_.time());
    const scalar now = time.value();

    for (label level = 0; level < levels; ++level)
    {
        time.setTime(now, interval);
        const bool changed = mesh->update();
        time.setTime(now, 0);
        if (!changed)
        {
            break;
        }
        markInterface();
    }
    mesh->topoChanging(false);

    // The faces that are new have no flux of their own yet
    if (mesh_.foundObject<surfaceScalarField>("phi"))
    {
        mesh_.lookupObjectRef<surfaceScalarField>("phi") = fvc::flux(U());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::demCloud::demCloud(const fvMesh& mesh, const fluidAccess access)
:
    cloud(mesh, "demCloud"),
    mesh_(mesh),
    dict_(propertiesFile(mesh)),
    coupling_("none"),
    effects_(dict_),
    patches_(mesh),
    bins_(mesh),
    cells_(bins_, access != fluidAccess::none),
    exits_(mesh),
    ledger_
    (
        access == fluidAccess::none ? ledger::solver::none
      : access == fluidAccess::look ? ledger::solver::whole
      : ledger::solver::open
    ),
    timeIndex_(-1),
    vtp_(false),
    network_(false),
    projected_(false),
    open_(false),
    advancing_(false),
    meshMoved_(false),
    meshChanged_(false),
    wallsMove_(false),
    watch_(mesh, [this]() { meshMoved(); })
{
    Info<< "demCloud: reading " << dict_.objectPath() << endl;

    checkInput();
    if (!effects_.automatic || dict_.found("coupling"))
    {
        coupling_ = dem::getChoice
        (
            dict_,
            "coupling",
            {"none", "fluidToParticles", "particlesToFluid", "twoWay"}
        );
    }
    if (access == fluidAccess::none)
    {
        coupling_ = "none";
    }
    planAccuracy(access);
    chooseContacts(access);
    const dem::demInput input(solverInput(access));
    dem_ = dem::demSolver::New(input);
    chooseEffects(access, input.restart);
    patches_.check
    (
        *dem_,
        immersedBodies()
    );
    meters_.reset
    (
        new dem::meterSet
        (
            dict_,
            patches_.period(),
            mesh.time().rootPath()/mesh.time().globalCaseName()
           /"postProcessing",
            mesh.time().timeName()
        )
    );
    chooseCouplingAccuracy();
    readCoupling(access);
    readOutput();

    const bool goesOn =
        input.restart
     && cloudState::read
        (
            mesh,
            *dem_,
            kinds_,
            immersed_.valid() ? immersed_.get() : nullptr,
            points_.valid() ? points_.get() : nullptr
        );
    if (input.restart)
    {
        const IOdictionary saved
        (
            cloudState::counters(mesh, IOobject::MUST_READ)
        );
        meters_->setCounters(saved.subOrEmptyDict("meters"));
    }
    if (!goesOn)
    {
        kinds_.update(mesh, cells_, dem_->state());
        startForces(0);
    }
    if (exchanged_.valid())
    {
        exchanged_->start();
    }

    const bool acts =
        access == fluidAccess::act || access == fluidAccess::share;

    // On a mesh that stays as it is nobody reads the field, unless it is named
    const bool asked =
        coupling::refinementInterface::asked(mesh_) || dict_.found("interface");
    if (acts && asked && (immersed_.valid() || !points_.valid()))
    {
        interface_.reset
        (
            new coupling::refinementInterface
            (
                mesh,
                bins_,
                dict_.found("interface")
              ? dict_.subDict("interface")
              : dictionary()
            )
        );
        refineInitially(input.restart);
    }

    readWatchdog();

    if (!input.restart)
    {
        cloudState::markStart(mesh);
    }

    Info<< "    coupling " << coupling_ << ", " << dem_->nBodies()
        << " bodies of " << dem_->group().sum(dem_->state().nSpheres())
        << " spheres"
        << (dem_->group().shared() ? ", shared out between the ranks" : "")
        << endl;
    const caseCheck looked(check(false));
    looked.writeAdvice(Info);
    writeAccuracy(looked);
    for (const caseCheck::figure& f : looked.figures())
    {
        if (!pointBodies() && f.name == "cellsOverDiameter")
        {
            ledger_.setCells(f.value);
        }
    }
}


Foam::demCloud::~demCloud()
{
    close();
}


// ************************************************************************* //
