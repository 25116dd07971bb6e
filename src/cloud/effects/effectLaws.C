/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "effectLaws.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
typedef const sceneNumbers& scene;

// Where laws are asked

    bool asPoint(scene n)
    {
        return n.inFluid() && n.point();
    }

    bool stirs(scene n)
    {
        return asPoint(n) && n.turbulent;
    }

    bool asSolid(scene n)
    {
        return n.inFluid() && !n.point();
    }

    bool inFluid(scene n)
    {
        return n.inFluid();
    }

    bool alone(scene n)
    {
        return !n.inFluid();
    }

    bool anywhere(scene)
    {
        return true;
    }


// One effect, one number

    scalar drag(scene n)
    {
        // Bodies that meet and fall can gather up to a bed, where it is largest
        sceneNumbers bed(n);
        bed.fraction = n.g > 0 && n.fraction > 1e-3 ? 0.55 : n.fraction;
        return bed.dragShare();
    }

    scalar displaced(scene n)
    {
        return n.g > 0 ? n.densityRatio() : 0;
    }

    scalar pressure(scene n)
    {
        // In a bed that it carries, the gradient is the solids' weight
        return max(n.densityRatio(), n.g > 0 ? n.fraction : scalar(0));
    }

    scalar stress(scene n)
    {
        return n.densityRatio();
    }

    scalar addedMass(scene n)
    {
        return 0.5*n.densityRatio();
    }

    scalar history(scene n)
    {
        return
            std::sqrt(9*n.rhoF/((2*n.rhoP + n.rhoF)*n.f()))*n.dragShare();
    }

    scalar shearLift(scene n)
    {
        return 1.615/(3*M_PI)*std::sqrt(n.shearRe())/n.f()*n.dragShare();
    }

    scalar spinLift(scene n)
    {
        const scalar Re = n.Re();
        const scalar ReSpin = n.spinRe();
        if (!(Re > 0) || !(ReSpin > 0))
        {
            return 0;
        }
        const scalar slow = ReSpin/Re;
        const scalar measured =
            0.45
          + (slow - 0.45)
           *std::exp(-0.05684*std::pow(ReSpin, 0.4)*std::pow(Re, 0.3));
        return min(slow, measured)*Re/(24*n.f())*n.dragShare();
    }

    scalar turning(scene n)
    {
        const scalar rim = 0.5*n.spin*n.d;
        return rim > 0 ? rim/std::hypot(rim, n.slip) : 0;
    }

    scalar eddies(scene n)
    {
        const scalar v = n.stirred();
        return v > 0 ? v/std::hypot(v, n.slip)*n.dragShare() : 0;
    }

    scalar crowding(scene n)
    {
        return std::pow(1 - min(n.fraction, scalar(0.65)), -2.65) - 1;
    }

    scalar meanFraction(scene n)
    {
        return n.meanFraction;
    }

    scalar fraction(scene n)
    {
        return n.nBodies > 1 ? n.fraction : 0;
    }

    scalar others(scene n)
    {
        return max(n.nBodies - 1, scalar(0));
    }

    scalar cellOverGap(scene n)
    {
        return n.cell/max(n.gap, VSMALL);
    }

    scalar softImpact(scene n)
    {
        // A film matters where bodies meet at all
        const scalar meets = n.meets();
        return meets > 0 ? meets/max(n.impactStokes(), VSMALL) : 0;
    }

    scalar cellsOverDiameter(scene n)
    {
        return n.cellsOverDiameter();
    }

    scalar emptyPart(scene n)
    {
        // Fine cells fill a box of three diameters around each body
        return 1 - min(scalar(1), 52*n.meanFraction);
    }

    scalar walls(scene n)
    {
        return n.walls;
    }

    scalar capillary(scene n)
    {
        return n.capillary;
    }

    scalar vanDerWaals(scene n)
    {
        return n.vanDerWaals;
    }

    scalar simplifiedJKR(scene n)
    {
        return n.simplifiedJKR;
    }

    scalar electrostatic(scene n)
    {
        return n.electrostatic;
    }

    scalar rolling(scene n)
    {
        return n.rolling;
    }


const char* const thesis3 = "thesis ch. 3";
const char* const map = "Elghobashi 1994";

//- Name, number, function, bar, where, source, cost
const std::vector<effectLaw> laws
({
    {
        "drag", "drag over drive", drag, 0, asPoint, thesis3,
        "samples u at each body"
    },
    {
        "buoyancy", "density ratio", displaced, 0, asPoint, "thesis 5.5",
        "a product a body"
    },
    {
        "pressureGradient", "density ratio or solid fraction", pressure, 0,
        asPoint, "thesis 3.1", "a gradient of p an exchange"
    },
    {
        "viscous", "density ratio", stress, 0, asPoint, "thesis 3.1",
        "a Laplacian of u an exchange"
    },
    {
        "virtualMass", "half density ratio", addedMass, 0, asPoint,
        "thesis 3.3", "a gradient of u an exchange"
    },
    {
        "basset", "history over drag or weight", history, 0, asPoint,
        "thesis 3.4",
        "20 to 30 vectors of memory a body"
    },
    {
        "saffman", "shear lift over drag", shearLift, 0, asPoint,
        "Saffman 1965", "a gradient of u an exchange"
    },
    {
        "magnus", "spin lift over drag", spinLift, 0, asPoint,
        "Oesterle & Bui Dinh 1998", "a gradient of u an exchange"
    },
    {
        "rotationalDrag", "rim over slip velocity", turning, 0, asPoint,
        "thesis ch. 3", "a gradient of u an exchange"
    },
    {
        "dispersion", "turbulence given over slip", eddies, 0, stirs,
        "Tchen, Csanady 1963", "k, epsilon, 3 random numbers"
    },
    {
        "denseDrag", "crowding of drag", crowding, 0, asPoint,
        "Wen & Yu 1966", "a power a body"
    },
    {
        "exchange", "mean solid fraction", meanFraction, 1e-6, asPoint, map,
        "a sum to the cells an exchange"
    },
    {
        "immersed", "cells over diameter", cellsOverDiameter,
        sceneNumbers::fills, asSolid, "Uhlmann 2005",
        "volume fractions each step"
    },
    {
        "refinement", "domain without bodies", emptyPart, 0, asSolid,
        "thesis ch. 9", "new cells when bodies move"
    },
    {
        "contacts", "solid fraction", fraction, sceneNumbers::often, inFluid,
        map,
        "pairs, small steps while they touch"
    },
    {
        "contacts", "cell over gap", cellOverGap, 0.5, asSolid,
        "two cells", "pairs, small steps while they touch"
    },
    {
        "contacts", "other bodies", others, 1e-3, alone, "no fluid",
        "pairs, small steps while they touch"
    },
    {
        "lubrication", "1/Stokes number of impact", softImpact, 0.1, asPoint,
        "Joseph et al. 2001", "a force a pair"
    },
    {
        "lubrication", "cell over gap", cellOverGap, 1, asSolid,
        "one cell", "a force a pair"
    },
    {
        "walls", "walls", walls, 0, anywhere, "given", "triangles near bodies"
    },
    {
        "capillary", "Bond number", capillary, 0, anywhere, "thesis 2.17",
        "a list of pairs within reach"
    },
    {
        "vanDerWaals", "Hamaker number", vanDerWaals, 0, anywhere,
        "thesis 2.16", "a list of pairs within reach"
    },
    {
        "simplifiedJKR", "Bond number", simplifiedJKR, 0, anywhere,
        "thesis ch. 2", "a product a contact"
    },
    {
        "electrostatic", "charge over weight", electrostatic, 0, anywhere,
        "thesis 2.15", "a list of pairs within reach"
    },
    {
        "rolling", "rolling over sliding friction", rolling, 0, anywhere,
        "Ai et al. 2011", "a torque a contact"
    }
});

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const std::vector<Foam::effectLaw>& Foam::effectLaws::all()
{
    return laws;
}


// ************************************************************************* //
