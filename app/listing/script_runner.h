#pragma once

#include "app/listing/scene_cells.h"
#include "app/listing/script_engine.h"
#include "app/listing/source_scan.h"
#include "app/listing/values.h"
#include "app/listing/vocabulary.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace AngelScript {
class asIScriptContext;
class asIScriptFunction;
}

namespace listing {

using AngelScript::asIScriptContext;
using AngelScript::asIScriptFunction;
using AngelScript::asIScriptModule;

/// Returns why a number stops a frame or a rule: it is infinite or not a number.
/// @param name the number, such as "The force"
std::string notFiniteSentence(const std::string &name);

/// Runs functions of a compiled text on a scene, within the bounds of limits.h, and says where and why they stop. Only one
/// thread may use it at a time.
class ScriptRunner
{
public:
    virtual ~ScriptRunner();
    ScriptRunner(const ScriptRunner &) = delete;
    ScriptRunner &operator=(const ScriptRunner &) = delete;

    const std::vector<CompileError> &errors() const { return m_script.errors(); }

protected:
    /// Compiles the text of `scan`. Both references must outlive this object.
    /// @param maxLines see execute()
    ScriptRunner(const SourceScan &scan, const Vocabulary &vocabulary, BodyAccess access, int maxLines);

    SceneCells &cells() { return m_cells; }
    const SceneCells &cells() const { return m_cells; }
    const SourceScan &scan() const { return m_scan; }
    /// Returns the compiled text; null if it is empty or has mistakes.
    asIScriptModule *module() const { return m_module; }
    asIScriptContext &context() const { return *m_context; }
    void addError(int line, int column, std::string sentence)
    {
        m_script.addError(line, column, std::move(sentence));
    }
    /// Adds an error at the first word `name` of the text.
    void addErrorAt(const std::string &name, std::string sentence);
    /// Makes the context after the text turned out to have no errors.
    void makeContext();

    /// Sets the counted lines to 0.
    void restartCount() { m_cues = m_lastLine = m_lastDepth = 0; }
    /// Executes the function that the context is prepared for. Returns whether it reached its end. More than `maxLines`
    /// lines since restartCount() are an error.
    bool execute();
    /// Stops the running function.
    void abort();
    /// Stops the running function with an error, unless it had one before.
    void fail(RunErrorKind kind, int line, std::string sentence);
    const std::optional<RunError> &error() const { return m_error; }
    void setError(RunError error) { m_error = std::move(error); }
    void forgetError() { m_error.reset(); }
    int lastLine() const { return m_lastLine; }

    /// Called before each line that runs.
    virtual void onNewLine(int, int, int) {}
    /// Returns the variables in scope.
    virtual std::vector<Variable> variables() const;
    /// Whether values of globals are computed: their lines are not lines of a function.
    bool m_isInitialising = false;

private:
    /// The scope of each variable of a function of the interpreter, by its number. Empty: not known.
    using Scopes = std::vector<Extent>;

    void onLine();
    /// Returns the line of the innermost loop that runs, in this call or in one around it; 0 if none does.
    int lineOfRunningLoop() const;
    void onException();
    const Scopes &scopesOf(asIScriptFunction *function) const;
    static void lineCallback(asIScriptContext *context, void *self);
    static void exceptionCallback(asIScriptContext *context, void *self);

    const SourceScan &m_scan;
    ScriptEngine m_script;
    SceneCells m_cells;
    asIScriptModule *m_module = nullptr;
    asIScriptContext *m_context = nullptr;
    mutable std::map<asIScriptFunction *, Scopes> m_scopes;

    int m_maxLines;
    std::optional<RunError> m_error;
    int m_cues = 0;      ///< calls of onLine()
    int m_lastLine = 0;  ///< of the last cue
    int m_lastDepth = 0; ///< of the last cue
};

}
