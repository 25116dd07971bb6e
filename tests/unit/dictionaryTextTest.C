/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    The text of a dictionary: what OpenFOAM's reader passes over is an error
    that names the line, and what is right is left alone.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "dictionaryText.H"

#include <fstream>

using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- What checkText says of a text; nothing if it is right
std::string said(const std::string& text)
{
    const Foam::fileName file("dictionaryTextTest.txt");
    {
        std::ofstream os(file);
        os << text;
    }
    return messageOf([&]() { Foam::dem::checkText(file); });
}


void expectSaid(const std::string& text, const std::vector<std::string>& all)
{
    const std::string message = said(text);
    for (const std::string& words : all)
    {
        EXPECT_NE(message.find(words), std::string::npos)
            << "'" << words << "' is not in: " << message;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(dictionaryText, right)
{
    EXPECT_EQ(said("a 1; b { a 2; } c (1 (2 3)); d ({ a 1; } { a 2; });"), "");
    EXPECT_EQ(said("/* a 1; */ a 1; // a 2;\nb \"a; { ( \\\" \"; c word;"), "");
    EXPECT_EQ(said("#include \"x\"\n$b;\n$b;\na $c; d{a 1;}e{a 1;}"), "");
    EXPECT_EQ(said("#ifeq x y\na 1;\n#else\na 2;\n#endif\n"), "");
    EXPECT_EQ(said("a #{ } ( \" #};\n\"b.*\" 1; \"b\" 2;"), "");
    EXPECT_EQ(said(""), "");
}


TEST(dictionaryText, twice)
{
    expectSaid("a 1;\nb 2;\na 3;\n", {"'a'", "line 1", "line 3", "twice"});
    expectSaid("x\n{\n    a 1;\n    a { }\n}", {"'a'", "line 3", "line 4"});
    expectSaid("x { }\ny 1;\nx { }\n", {"'x'", "line 1", "line 3"});
}


TEST(dictionaryText, noEnd)
{
    expectSaid("a 1;\n/* b 2;\nc 3;\n", {"comment", "no end", "line 2"});
    expectSaid("a 1;\n\nb \"c;\n", {"string", "no end", "line 3"});
    expectSaid("a\n{\n    b 1;\n", {"no end for the '{'", "line 2"});
    expectSaid("a (1 2;\n", {"no end for the '('", "line 1"});
    expectSaid("a 1;\nb 2\n", {"no ';' after 'b'", "line 2"});
    expectSaid("a 1;\n}\n", {"no '{' for this '}'", "line 2"});
    expectSaid("a (1 2};\n", {"'('", "ends with '}'"});
}


// ************************************************************************* //
