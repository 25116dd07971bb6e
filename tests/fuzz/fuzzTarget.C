/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    fuzzTarget

Description
    Reads one input after the other as a run would, each in a process of its
    own that is forked from one that has the mesh already: some milliseconds
    an input, and no input can spoil the next.

    On each line of the standard input it reads the case, which the fuzzer has
    spoilt, or with -surfaces the file on that line. It answers with

        accepted SECONDS
        rejected SECONDS
        broken SECONDS            the run went on with a state that is none
        crash SIGNAL SECONDS
        hang SECONDS

    What the run said is in the file log, at its end the state's hash. Accepted
    means: all steps done, all numbers of the state finite, quaternions of
    length one, masses and moments of inertia above zero.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "columnFvMesh.H"
#include "Time.H"
#include "volFields.H"
#include "surfaceFields.H"
#include "fvm.H"
#include "fvcFlux.H"
#include "fvMatrices.H"
#include "closedSurface.H"
#include "demCloud.H"
#include "multisphereErrors.H"
#include "multisphereGenerator.H"

#include <cmath>
#include <fcntl.h>
#include <iostream>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

enum verdict
{
    accepted = 40,
    rejected = 41,
    broken = 42
};


//- FNV-1a of the bits of numbers
class hashOf
{
    uint64_t h_ = 14695981039346656037ULL;

public:

    //- What OpenFOAM reads as 0 counts as 0
    void add(const scalar value)
    {
        const scalar x = mag(value) < VSMALL ? 0 : value;
        unsigned char byte[sizeof(x)];
        std::memcpy(byte, &x, sizeof(x));
        for (const unsigned char c : byte)
        {
            h_ = (h_ ^ c)*1099511628211ULL;
        }
    }

    template<class Form, class Cmpt, direction n>
    void add(const VectorSpace<Form, Cmpt, n>& v)
    {
        for (direction d = 0; d < n; ++d)
        {
            add(v[d]);
        }
    }

    uint64_t operator()() const
    {
        return h_;
    }
};


//- Is the state one that a run may go on with?
bool isSound(const dem::bodies& state)
{
    forAll(state.x, b)
    {
        const scalar sum =
            mag(state.x[b]) + mag(state.v[b]) + mag(state.L(b))
          + mag(state.omega[b]) + mag(state.force[b]) + mag(state.torque[b])
          + mag(state.fluidForce[b]) + mag(state.fluidTorque[b]);
        if
        (
            !std::isfinite(sum)
         || !(mag(mag(state.q[b]) - 1) < 1e-6)
         || !(state.mass[b] > 0) || !std::isfinite(state.mass[b])
         || !(cmptMin(state.inertia(b)) > 0)
         || !std::isfinite(mag(state.inertia(b)))
        )
        {
            Info<< "broken: body " << state.id[b] << " x " << state.x[b]
                << " v " << state.v[b] << " q " << state.q[b] << " mass "
                << state.mass[b] << " I " << state.inertia(b) << " F "
                << state.force[b] << endl;
            return false;
        }
    }
    forAll(state.sphereX(), s)
    {
        if
        (
            !std::isfinite(mag(state.sphereX()[s]))
         || !(state.sphereR[s] > 0) || !std::isfinite(state.sphereR[s])
        )
        {
            Info<< "broken: sphere " << s << endl;
            return false;
        }
    }
    return true;
}


uint64_t hashOfState(const dem::bodies& state)
{
    hashOf h;
    forAll(state.x, b)
    {
        h.add(scalar(state.id[b]));
        h.add(scalar(state.shapeI[b]));
        h.add(state.mass[b]);
        h.add(state.x[b]);
        h.add(state.v[b]);
        h.add(state.L(b));
        h.add(state.q[b].w());
        h.add(state.q[b].v());
    }
    return h();
}


//- Some steps of the case
verdict runCase(Time& runTime, fvMesh& mesh, const bool fluid, const label n)
{
    autoPtr<volVectorField> U;
    autoPtr<surfaceScalarField> phi;
    autoPtr<volScalarField> nu;
    if (fluid)
    {
        U.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "U",
                    runTime.timeName(),
                    mesh,
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE
                ),
                mesh
            )
        );
        phi.reset(new surfaceScalarField("phi", fvc::flux(*U)));
        nu.reset
        (
            new volScalarField
            (
                IOobject("nu", runTime.timeName(), mesh),
                mesh,
                dimensionedScalar("nu", dimViscosity, 1e-6)
            )
        );
    }

    demCloud cloud
    (
        mesh,
        fluid ? demCloud::fluidAccess::act : demCloud::fluidAccess::none
    );
    const dem::bodies& state = cloud.dem().state();
    if (!isSound(state))
    {
        return broken;
    }

    for (label i = 0; i < n; ++i)
    {
        ++runTime;
        if (fluid)
        {
            // A momentum equation without flow and pressure
            fvVectorMatrix UEqn
            (
                fvm::ddt(*U) - fvm::laplacian(*nu, *U)
            );
            cloud.addForcing(UEqn);
            UEqn.solve();
            cloud.correct(*U);
            if (!std::isfinite(gSum(mag(U->primitiveField())())))
            {
                Info<< "broken: velocity of the fluid" << endl;
                return broken;
            }
        }
        else
        {
            cloud.beginStep();
        }
        cloud.endStep();
        if (!isSound(state))
        {
            return broken;
        }
    }
    Info<< "hash " << Foam::name(label(hashOfState(state) % 1000000007)) << ' '
        << state.size() << " bodies" << endl;
    return accepted;
}


//- A few spheres in a surface
verdict runSurface(const fileName& file)
{
    const dem::closedSurface body(file, 1);
    dem::multisphereGenerator::controls controls;
    controls.cells = 8;
    dem::multisphereGenerator cluster(body, controls);
    cluster.generate(3);

    hashOf h;
    bool sound =
        body.properties().volume > 0
     && std::isfinite(body.properties().volume);
    forAll(cluster.radii(), s)
    {
        h.add(cluster.centres()[s]);
        h.add(cluster.radii()[s]);
        sound =
            sound && cluster.radii()[s] > 0
         && std::isfinite(mag(cluster.centres()[s]) + cluster.radii()[s]);
    }
    Info<< "hash " << Foam::name(label(h() % 1000000007)) << ' '
        << cluster.radii().size() << " spheres, volume "
        << body.properties().volume << endl;
    return sound ? accepted : broken;
}


//- In the child: run one input, all that it says to the file log
template<class Run>
[[noreturn]] void inChild(const Run& run, const label seconds)
{
    const int log = ::open("log", O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(log, 1);
    ::dup2(log, 2);
    rlimit limit{rlim_t(seconds), rlim_t(seconds + 5)};
    ::setrlimit(RLIMIT_CPU, &limit);
    limit = rlimit{0, 0};
    ::setrlimit(RLIMIT_CORE, &limit);

    verdict v = rejected;
    try
    {
        v = run();
    }
    catch (const Foam::IOerror& e)
    {
        Info<< "error: " << e.message() << nl << "file: " << e.ioFileName()
            << " at line " << e.ioStartLineNumber() << endl;
    }
    catch (const Foam::error& e)
    {
        Info<< "error: " << e.message() << endl;
    }
    // Any other exception ends the process as it would end a run
    Info<< flush;
    ::_exit(v);
}


scalar now()
{
    timespec t;
    ::clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption("surfaces", "Read surfaces, not the case");
    argList::addBoolOption("fluid", "With the coupling");
    argList::addOption("steps", "N", "Steps of an input (default: 3)");
    argList::addOption("seconds", "N", "An input that takes longer hangs");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const bool surfaces = args.found("surfaces");
    const bool fluid = args.found("fluid");
    const label steps = args.getOrDefault<label>("steps", 3);
    const label seconds = args.getOrDefault<label>("seconds", 10);

    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    ::chdir((runTime.rootPath()/runTime.globalCaseName()).c_str());
    std::cout << "ready" << std::endl;

    std::string line;
    while (std::getline(std::cin, line))
    {
        const scalar start = now();
        std::cout.flush();
        const pid_t child = ::fork();
        if (child == 0)
        {
            if (surfaces)
            {
                inChild([&]() { return runSurface(line); }, seconds);
            }
            inChild
            (
                [&]() { return runCase(runTime, mesh, fluid, steps); },
                seconds
            );
        }

        int status = 0;
        bool late = false;
        while (::waitpid(child, &status, WNOHANG) == 0)
        {
            ::usleep(500);
            // By the clock, if it sleeps: the CPU time has its own limit
            if (!late && now() - start > 10*seconds)
            {
                late = true;
                ::kill(child, SIGKILL);
            }
        }
        const scalar took = now() - start;

        if (late || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
        {
            std::cout << "hang " << took << std::endl;
        }
        else if (WIFSIGNALED(status))
        {
            std::cout << "crash " << WTERMSIG(status) << ' ' << took
                << std::endl;
        }
        else
        {
            switch (WEXITSTATUS(status))
            {
                case accepted:
                    std::cout << "accepted " << took << std::endl;
                    break;
                case rejected:
                    std::cout << "rejected " << took << std::endl;
                    break;
                case broken:
                    std::cout << "broken " << took << std::endl;
                    break;
                case 1:
                    // OpenFOAM's own end of a program, with a message
                    std::cout << "rejected " << took << std::endl;
                    break;
                default:
                    std::cout << "crash " << -WEXITSTATUS(status) << ' '
                        << took << std::endl;
            }
        }
    }
    return 0;
}


// ************************************************************************* //
