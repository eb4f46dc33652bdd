#pragma once

#include "app/listing/tokens.h"
#include "app/listing/values.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace listing {

/// The part of a text from `begin` to before `end`, in bytes.
struct Extent
{
    std::size_t begin = 0;
    std::size_t end = 0;
    bool contains(std::size_t offset) const { return offset >= begin && offset < end; }
};

/// A variable or a parameter of a function.
struct Declaration
{
    std::string name;
    std::size_t offset = 0; ///< of the name
    Extent scope;           ///< from behind its declaration to the end of its block
};

/// A loop of a listing.
struct Loop
{
    int line = 0; ///< of its first word
    Extent head;  ///< from its first word up to its body; for `do` the condition behind the body
    Extent body;
    Extent whole;
};

/// A function of a listing.
struct FunctionText
{
    std::string name;
    Extent extent;                         ///< from its parameters to its last brace
    std::vector<Declaration> declarations; ///< parameters first, then in the order of the text
};

/// The structure of a listing's text, as far as stepping through it needs it. The interpreter does not tell where
/// the scope of a variable ends, nor where loops are.
class SourceScan
{
public:
    /// Scans a text. Any text can be scanned, also one that does not compile.
    explicit SourceScan(std::string text);
    SourceScan(const SourceScan &) = delete;
    SourceScan &operator=(const SourceScan &) = delete;

    /// Returns the first violation of the rules in language_rules.h, or the first variable without a value.
    const std::optional<CompileError> &error() const { return m_error; }
    const std::string &text() const { return m_text; }
    /// Returns the error that a brace is never closed, if the rest of the text can be compiled nevertheless.
    const std::optional<CompileError> &unclosed() const { return m_unclosed; }
    /// Returns the text for the interpreter, with the same positions. `const` before Vec2, Body and Creature is left out, because
    /// an initial value of another type would end AngelScript 2.35.1. Missing closing braces are there, so that the
    /// mistakes before the end are found while the text is being typed.
    std::string compiledText() const;
    const Tokens &tokens() const { return m_tokens; }
    const std::vector<FunctionText> &functions() const { return m_functions; }
    const std::vector<Loop> &loops() const { return m_loops; }
    /// Returns the names of all functions, variables and parameters.
    std::vector<std::string> declaredNames() const;
    /// Returns how a function of the text is called, for example "move(Body branch)"; empty for other names.
    std::string formOf(std::string_view function) const;
    /// Returns whether there are variables outside of functions.
    bool hasGlobals() const { return !m_globals.empty(); }
    /// Returns whether the word `name` at a byte is a variable of the text, or a parameter of one of its functions: there it
    /// is declared, or in scope.
    bool declares(std::string_view name, std::size_t offset) const;
    /// Returns whether the word `name` is used.
    bool uses(std::string_view name) const;
    /// Returns the function around `offset`, or null.
    const FunctionText *functionAt(std::size_t offset) const;
    /// Returns the bytes before a position (from 1), at most the length of the text.
    std::size_t offsetOf(int line, int column) const;
    /// Returns the line of a byte, from 1.
    int lineOf(std::size_t offset) const;
    /// Returns the length of the word at a position, at least 1.
    int lengthAt(int line, int column) const;

private:
    void parse();
    void fail(const Token &token, std::string sentence);
    /// Finds the braces that are never closed, and where their partners belong.
    void closeBraces();
    /// Parses the statement at token `i`, whose block ends at byte `blockEnd`.
    void statement(std::size_t i, std::size_t blockEnd);
    /// Returns the index after the statement at token `i`.
    std::size_t afterStatement(std::size_t i) const;
    /// Parses declarations from token `i` to `end` with the given scope end. Does nothing if there are none.
    void declarations(std::size_t i, std::size_t end, std::size_t scopeEnd);
    void parameters(std::size_t i, std::size_t end, std::size_t scopeEnd);

    std::string m_text;
    Tokens m_tokens; ///< of m_text; none if that is too long
    std::vector<std::size_t> m_lineStarts;
    std::optional<CompileError> m_error, m_unclosed;
    std::vector<std::size_t> m_missingBraces; ///< the bytes before which they belong, in order
    std::vector<FunctionText> m_functions;
    std::vector<Declaration> m_globals;
    std::vector<Declaration> *m_into = nullptr; ///< the declarations of the current function
    std::vector<Loop> m_loops;
};

}
