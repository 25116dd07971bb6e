/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    A figure that misses its bar fails, a NaN too.

\*---------------------------------------------------------------------------*/

#include "figure.H"

#include <gtest/gtest-spi.h>

#include <algorithm>
#include <limits>

using namespace styxTest;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(figure, missesItsBar)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    testing::internal::CaptureStdout();

    EXPECT_NONFATAL_FAILURE(figure("a", 3, 1, 2, "m", "-"), "misses its bar");
    EXPECT_NONFATAL_FAILURE(figure("b", nan, 1, noBar, "m", "-"), "misses");
    EXPECT_NONFATAL_FAILURE(figureNear("c", nan, 1, 1, "m", "-"), "misses");
    figureNear("d", 99.5, 100, 0.01, "m", "a book");

    const std::string said = testing::internal::GetCapturedStdout();

    EXPECT_EQ(said.substr(0, said.find('\n')), "FAIL a: 3 m (1 to 2, -)");
    EXPECT_NE
    (
        said.find("PASS d: 99.5 m (100 within 1 %, a book)"),
        std::string::npos
    );

    figure
    (
        "unitFigureLines",
        std::count(said.begin(), said.end(), '\n'),
        4,
        4,
        "lines",
        "tests/README.md"
    );
}


// ************************************************************************* //
