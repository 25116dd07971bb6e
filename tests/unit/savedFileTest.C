/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    Files of a restart that have not the form of a field; the checksum of the
    counters.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "savedFile.H"

#include <fstream>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

std::string said(const std::string& text)
{
    const fileName file("savedFileTest");
    {
        std::ofstream os(file);
        os << text;
    }
    return messageOf([&]() { cloudState::checkSavedFile(file, 10); });
}


std::string head(const std::string& format, const std::string& type)
{
    return
        "FoamFile\n{\n    version 2.0;\n    format " + format
      + ";\n    class " + type + ";\n    arch \"LSB;label="
      + std::to_string(8*sizeof(label)) + ";scalar=64\";\n}\n// * //\n\n";
}


std::string bytesOf(const std::vector<label>& values)
{
    return "(" + std::string
    (
        reinterpret_cast<const char*>(values.data()),
        values.size()*sizeof(label)
    ) + ")";
}


void expect(const std::string& text, const std::string& words)
{
    const std::string message = said(text);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_NE(message.find("savedFileTest"), std::string::npos) << message;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(savedFile, textChecksum)
{
    const auto sum = [](const std::string& s)
    {
        return cloudState::textChecksum(dictionaryOf(s));
    };
    EXPECT_EQ(sum("a 1; b { c (1 2 3); }"), sum("a  1;\nb{ c ( 1 2 3 );}"));
    EXPECT_NE(sum("a 1; b { c (1 2 3); }"), sum("a 1; b { c (1 2 4); }"));
    EXPECT_NE(sum("a 1;"), sum("b 1;"));

    // What is written with all digits is read as the same
    const std::string x(text(scalar(1)/3));
    EXPECT_EQ(sum("a " + x + ";"), sum("a " + x + ";"));
    EXPECT_GE(sum("a 1;"), 0);
}


TEST(savedFile, good)
{
    EXPECT_EQ(said(head("ascii", "labelField") + "3(1 2 3)\n"), "");
    EXPECT_EQ(said(head("ascii", "scalarField") + "5{0}\n"), "");
    EXPECT_EQ(said(head("ascii", "labelFieldField")
        + "2\n(\n3(1 2 3)\n0()\n)\n"), "");
    EXPECT_EQ(said(head("binary", "labelField") + "2\n" + bytesOf({7, 8})), "");
    EXPECT_EQ(said(head("binary", "labelFieldCompactField") + "3\n"
        + bytesOf({0, 1, 2}) + "\n2\n" + bytesOf({4, 5})), "");
}


TEST(savedFile, wrong)
{
    expect("nothing", "no head");
    expect(head("text", "labelField") + "1(1)", "neither ascii nor binary");
    expect(head("ascii", "labelField") + "11(1)", "'11', cannot be");
    expect(head("ascii", "labelField") + "999999999999{1}", "cannot be");
    expect(head("ascii", "labelFieldField") + "1(999999999(1 2))",
        "999999999, cannot be");
    expect(head("binary", "labelField") + "3\n" + bytesOf({7, 8}),
        "not 3 entries");
    expect(head("binary", "wordField") + "1\n" + bytesOf({7}),
        "'wordField', is not known");
    expect(head("binary", "labelFieldCompactField") + "3\n"
        + bytesOf({0, 9, 2}) + "\n2\n" + bytesOf({4, 5}), "offsets");
    expect(head("binary", "labelFieldCompactField") + "3\n"
        + bytesOf({0, 1, 2000}) + "\n2\n" + bytesOf({4, 5}), "offsets");

    std::string old(head("ascii", "labelField") + "1(1)");
    old.replace(old.find("2.0"), 3, "1e9");
    expect(old, "version");
}


// ************************************************************************* //
