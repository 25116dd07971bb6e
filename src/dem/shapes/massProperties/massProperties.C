/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "massProperties.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef Eigen::Matrix3d matrix;

// Moments (and terms off the diagonal) count as equal (as zero) below this
// fraction of the largest moment: the round-off of the integrals, with room
constexpr double roundOff = 1e-9;


// Axes of the plane across the unit vector u, near to the frame's own axes
void planeAxes(const Eigen::Vector3d& u, Eigen::Vector3d& a, Eigen::Vector3d& b)
{
    int across = 0;
    for (int k = 1; k < 3; ++k)
    {
        if (std::abs(u[k]) < std::abs(u[across]) - roundOff)
        {
            across = k;
        }
    }

    a = (Eigen::Vector3d::Unit(across) - u[across]*u).normalized();
    b = u.cross(a);
}


// Where two moments are equal, replace the arbitrary axes of their plane
void settleEqualMoments(const Eigen::Vector3d& moments, matrix& axes)
{
    const double tolerance = roundOff*moments[2];
    const bool low = (moments[1] - moments[0] < tolerance);
    const bool high = (moments[2] - moments[1] < tolerance);

    if (low && high)
    {
        axes.setIdentity();
    }
    else if (low || high)
    {
        const int single = low ? 2 : 0;
        const int first = low ? 0 : 1;

        Eigen::Vector3d a, b;
        planeAxes(axes.col(single), a, b);
        axes.col(first) = a;
        axes.col(first + 1) = b;
    }
}


// Name and sign the axes so that the rotation is nearest to none
void nameAxes(matrix& axes, Eigen::Vector3d& moments)
{
    static const int orders[6][3] =
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

    double best = -4;
    matrix bestAxes = axes;
    Eigen::Vector3d bestMoments = moments;

    for (const auto& order : orders)
    {
        for (int signs = 0; signs < 4; ++signs)
        {
            matrix m;
            m.col(0) = axes.col(order[0])*((signs & 1) ? -1 : 1);
            m.col(1) = axes.col(order[1])*((signs & 2) ? -1 : 1);
            m.col(2) = m.col(0).cross(m.col(1));

            // Trace of a rotation by an angle phi: 1 + 2 cos(phi)
            if (m.trace() > best + roundOff)
            {
                best = m.trace();
                bestAxes = m;
                for (int k = 0; k < 3; ++k)
                {
                    bestMoments[k] = moments[order[k]];
                }
            }
        }
    }

    axes = bestAxes;
    moments = bestMoments;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::dem::massProperties Foam::dem::massProperties::fromMoments
(
    const scalar volume,
    const vector& first,
    const symmTensor& second,
    const point& origin
)
{
    massProperties body;
    body.volume = volume;

    const vector arm(first/volume);
    body.centroid = origin + arm;

    // Parallel axes: second moments about the centroid
    const symmTensor central(second - volume*sqr(arm));
    body.inertia = tr(central)*symmTensor::I - central;

    return body;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::massProperties::principalAxes
(
    tensor& axes,
    vector& moments
) const
{
    const symmTensor& J = inertia;
    const scalar offDiagonal = max(max(mag(J.xy()), mag(J.xz())), mag(J.yz()));

    if (offDiagonal <= roundOff*max(max(J.xx(), J.yy()), J.zz()))
    {
        axes = tensor::I;
        moments = vector(J.xx(), J.yy(), J.zz());
        return;
    }

    matrix m;
    m << J.xx(), J.xy(), J.xz(),
         J.xy(), J.yy(), J.yz(),
         J.xz(), J.yz(), J.zz();

    const Eigen::SelfAdjointEigenSolver<matrix> solver(m);
    Eigen::Vector3d values = solver.eigenvalues();
    matrix columns = solver.eigenvectors();

    settleEqualMoments(values, columns);
    nameAxes(columns, values);

    for (direction i = 0; i < 3; ++i)
    {
        moments[i] = values[i];
        for (direction j = 0; j < 3; ++j)
        {
            axes(i, j) = columns(i, j);
        }
    }
}


// ************************************************************************* //
