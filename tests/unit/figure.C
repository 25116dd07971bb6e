/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Figures of unit tests, and the main program of the unit tests: it adds a
    line for each test that printed no figure, and one for each failure that
    no figure shows. OpenFOAM's errors are thrown, so that tests can catch them.

\*---------------------------------------------------------------------------*/

#include "figure.H"

#include "error.H"
#include "OSspecific.H"

#include <cmath>
#include <iostream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The key under which a test counts its figures
const char* const countKey = "figures";

//- A number as the lines show it
std::string shown(const double x)
{
    std::ostringstream os;
    os.precision(6);
    os << x;
    return os.str();
}

//- The bar in words
std::string bar(const double low, const double high)
{
    if (low == high)
    {
        return shown(low);
    }
    if (std::isinf(low))
    {
        return "at most " + shown(high);
    }
    if (std::isinf(high))
    {
        return "at least " + shown(low);
    }
    return shown(low) + " to " + shown(high);
}

void report
(
    const bool passed,
    const std::string& name,
    const double value,
    const std::string& unit,
    const std::string& bar,
    const std::string& source
)
{
    std::cout
        << (passed ? "PASS " : "FAIL ") << name << ": " << shown(value) << ' '
        << unit << " (" << bar << ", " << source << ")" << std::endl;

    ::testing::Test::RecordProperty(countKey, 1);

    if (!passed)
    {
        ADD_FAILURE() << "figure " << name << " misses its bar";
    }
}


//- Prints the lines of tests and failures that no figure shows
class lines
:
    public ::testing::EmptyTestEventListener
{
    //- First failure of the running test that no figure shows
    std::string failure_;

    void OnTestStart(const ::testing::TestInfo&) override
    {
        failure_.clear();
    }

    void OnTestPartResult(const ::testing::TestPartResult& part) override
    {
        const std::string what(part.summary());

        if (part.failed() && failure_.empty() && what.find("misses its bar")
            == std::string::npos)
        {
            const char* file = part.file_name();
            failure_ =
                std::string(file ? file : "unknown file") + ":"
              + std::to_string(part.line_number()) + ": " + what;

            for (char& c : failure_)
            {
                if (c == '\n')
                {
                    c = ' ';
                }
            }
        }
    }

    void OnTestEnd(const ::testing::TestInfo& info) override
    {
        const ::testing::TestResult& result = *info.result();
        const std::string name =
            std::string(info.test_suite_name()) + "." + info.name();

        if (!failure_.empty())
        {
            std::cout
                << "FAIL " << name << ": " << failure_
                << " (no failure, GoogleTest)" << std::endl;
        }
        else if (result.Passed() && result.test_property_count() == 0)
        {
            std::cout
                << "PASS " << name << ": 0 failures (0, GoogleTest)"
                << std::endl;
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void styxTest::figure
(
    const std::string& name,
    const double value,
    const double low,
    const double high,
    const std::string& unit,
    const std::string& source
)
{
    const bool passed = std::isfinite(value) && low <= value && value <= high;

    report(passed, name, value, unit, bar(low, high), source);
}


void styxTest::figureNear
(
    const std::string& name,
    const double value,
    const double expected,
    const double relTol,
    const std::string& unit,
    const std::string& source
)
{
    const bool passed =
        std::abs(value - expected) <= relTol*std::abs(expected);

    report
    (
        passed,
        name,
        value,
        unit,
        shown(expected) + " within " + shown(100*relTol) + " %",
        source
    );
}


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    ::testing::InitGoogleTest(&argc, argv);
    ::testing::UnitTest::GetInstance()->listeners().Append(new lines);

    // What tests write goes beside the program, wherever it is started
    const Foam::fileName here = Foam::fileName(argv[0]).path()/"unit";
    Foam::mkDir(here);
    Foam::chDir(here);

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
