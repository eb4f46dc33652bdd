#include "app/listing/script_runner.h"

#include "app/listing/limits.h"

#include <angelscript.h>

#include <algorithm>

namespace listing {

using namespace AngelScript;

std::string notFiniteSentence(const std::string &name)
{
    return name +
           " is not a finite number. Look for the root of a negative number, or for a number that grows "
           "in each frame.";
}

ScriptRunner::ScriptRunner(const SourceScan &scan, const Vocabulary &vocabulary, BodyAccess access,
                           int maxLines)
    : m_scan(scan), m_script(scan, vocabulary), m_cells(m_script.engine(), vocabulary, access),
      m_module(m_script.build()), m_maxLines(maxLines)
{
}

ScriptRunner::~ScriptRunner()
{
    if (m_context)
        m_context->Release();
}

void ScriptRunner::addErrorAt(const std::string &name, std::string sentence)
{
    const Tokens &tokens = m_scan.tokens();
    const auto found =
        std::find_if(tokens.begin(), tokens.end(), [&](const Token &token) { return token.text == name; });
    const bool isFound = found != tokens.end();
    addError(isFound ? found->line : 1, isFound ? found->column : 1, std::move(sentence));
}

void ScriptRunner::makeContext()
{
    m_context = m_script.engine().CreateContext();
    m_context->SetLineCallback(asFUNCTION(lineCallback), this, asCALL_CDECL);
    m_context->SetExceptionCallback(asFUNCTION(exceptionCallback), this, asCALL_CDECL);
}

bool ScriptRunner::execute()
{
    return m_context->Execute() == asEXECUTION_FINISHED;
}

void ScriptRunner::abort()
{
    m_context->Abort();
}

void ScriptRunner::lineCallback(asIScriptContext *, void *self)
{
    static_cast<ScriptRunner *>(self)->onLine();
}

void ScriptRunner::exceptionCallback(asIScriptContext *, void *self)
{
    static_cast<ScriptRunner *>(self)->onException();
}

void ScriptRunner::fail(RunErrorKind kind, int line, std::string sentence)
{
    if (!m_error)
        m_error = RunError{kind, line, std::move(sentence), variables()};
    m_context->Abort();
}

int ScriptRunner::lineOfRunningLoop() const
{
    int found = 0;
    for (asUINT call = 0; call < m_context->GetCallstackSize() && found == 0; ++call) {
        int column = 0;
        const int line = m_context->GetLineNumber(call, &column);
        const std::size_t at = m_scan.offsetOf(line, column);
        for (const Loop &loop : m_scan.loops()) { // the innermost comes last
            if (loop.whole.contains(at))
                found = loop.line;
        }
    }
    return found;
}

void ScriptRunner::onLine()
{
    int column = 0;
    const int line = m_context->GetLineNumber(0, &column);
    const int depth = static_cast<int>(m_context->GetCallstackSize()) - 1;
    if (++m_cues > m_maxLines) {
        const int loopLine = lineOfRunningLoop();
        const std::string lines = " still runs after " + std::to_string(m_maxLines) + " lines. ";
        return loopLine > 0 ? fail(RunErrorKind::endlessLoop, loopLine,
                                   "This loop" + lines + "It ends only when its condition becomes false.")
                            : fail(RunErrorKind::endlessLoop, line,
                                   "This" + lines + "A function calls itself too often.");
    }
    if (depth > maxCallDepth)
        return fail(
            RunErrorKind::tooDeep, line,
            "Functions call functions " + std::to_string(maxCallDepth) +
                " times inside one another. A function that calls itself needs a case in which it does not.");
    const bool isNewLine = line != m_lastLine || depth != m_lastDepth;
    m_lastLine = line;
    m_lastDepth = depth;
    if (m_isInitialising || !isNewLine)
        return;
    onNewLine(line, column, depth);
}

void ScriptRunner::onException()
{
    const std::string text = m_context->GetExceptionString();
    const int line = m_context->GetExceptionLineNumber();
    RunErrorKind kind = RunErrorKind::other;
    std::string sentence = text;
    if (text.starts_with("There is no ")) {
        kind = RunErrorKind::noSuchBody;
    } else if (text == "Null pointer access") {
        kind = RunErrorKind::noSuchBody;
        sentence = "This variable stands for no body.";
    } else if (text == "Divide by zero") {
        kind = RunErrorKind::divisionByZero;
        sentence = "This divides by 0.";
    } else if (text == "Overflow in integer division" || text == "Overflow in exponent operation") {
        kind = RunErrorKind::notFinite;
        sentence = "The result is too large for a number.";
    } else if (text.starts_with("Stack overflow")) {
        kind = RunErrorKind::tooDeep;
        sentence = "Functions call functions too many times inside one another.";
    }
    if (!m_error)
        m_error = RunError{kind, line, std::move(sentence), variables()};
}

const ScriptRunner::Scopes &ScriptRunner::scopesOf(asIScriptFunction *function) const
{
    const auto [found, isNew] = m_scopes.try_emplace(function);
    Scopes &scopes = found->second;
    if (!isNew)
        return scopes;
    const FunctionText *text = nullptr;
    for (const FunctionText &candidate : m_scan.functions()) {
        // Functions with the same name differ by their lines.
        if (candidate.name == function->GetName() &&
            function->FindNextLineWithCode(m_scan.lineOf(candidate.extent.begin)) >= 0)
            text = &candidate;
    }
    std::map<std::string, std::size_t> seen; // declarations of each name so far
    for (asUINT i = 0; i < function->GetVarCount(); ++i) {
        const char *name = nullptr;
        function->GetVar(i, &name, nullptr);
        Extent scope;
        if (text && name && *name) {
            std::size_t number = seen[name]++;
            for (const Declaration &declaration : text->declarations) {
                if (declaration.name == name && number-- == 0) {
                    scope = declaration.scope;
                    break;
                }
            }
        }
        scopes.push_back(scope);
    }
    return scopes;
}

std::vector<Variable> ScriptRunner::variables() const
{
    std::vector<Variable> all;
    asIScriptFunction *function = m_isInitialising ? nullptr : m_context->GetFunction(0);
    int column = 0;
    const int line = function ? m_context->GetLineNumber(0, &column) : 0;
    // At the end of a function, the interpreter is behind its last brace. Its variables still exist.
    const std::size_t place = m_scan.offsetOf(line, column);
    const FunctionText *before = place > 0 ? m_scan.functionAt(place - 1) : nullptr;
    const std::size_t at = before && before->extent.end == place ? place - 1 : place;
    const int count = function ? m_context->GetVarCount(0) : 0;
    for (int i = 0; i < count; ++i) {
        const char *name = m_context->GetVarName(static_cast<asUINT>(i), 0);
        const Scopes &scopes = scopesOf(function);
        const auto index = static_cast<std::size_t>(i);
        if (!name || !*name || index >= scopes.size() || !scopes[index].contains(at) ||
            !m_context->IsVarInScope(static_cast<asUINT>(i), 0))
            continue;
        const std::optional<Value> value =
            m_cells.values().valueAt(m_context->GetAddressOfVar(static_cast<asUINT>(i), 0),
                                     m_context->GetVarTypeId(static_cast<asUINT>(i), 0));
        if (value)
            all.push_back({name, *value, false});
    }
    return all;
}

}
