#pragma once

#include "app/listing/source_scan.h"
#include "app/listing/values.h"
#include "app/listing/vocabulary.h"

#include <string>
#include <vector>

namespace AngelScript {
class asIScriptEngine;
class asIScriptModule;
struct asSMessageInfo;
}

namespace listing {

/// Prepares the calling thread for script engines. Each thread that uses one calls this first, any number of times.
void prepareScriptThread();

/// A script engine for one text, and the mistakes in that text. Only one thread may use it at a time.
class ScriptEngine
{
public:
    /// Both arguments must outlive this object.
    ScriptEngine(const SourceScan &scan, const Vocabulary &vocabulary);
    ~ScriptEngine();
    ScriptEngine(const ScriptEngine &) = delete;
    ScriptEngine &operator=(const ScriptEngine &) = delete;

    AngelScript::asIScriptEngine &engine() { return *m_engine; }
    /// Compiles the text after its names were registered. Returns null if it is empty, or has mistakes: see
    /// errors().
    AngelScript::asIScriptModule *build();
    const std::vector<CompileError> &errors() const { return m_errors; }
    /// Adds an error, if it is the first on its line: the interpreter's later ones follow from it.
    void addError(int line, int column, std::string sentence);

private:
    static void messageCallback(const AngelScript::asSMessageInfo *message, void *self);

    const SourceScan &m_scan;
    const Vocabulary &m_vocabulary;
    std::vector<CompileError> m_errors;
    AngelScript::asIScriptEngine *m_engine = nullptr;
};

}
