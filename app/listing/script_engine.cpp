#include "app/listing/script_engine.h"

#include "app/listing/common_slips.h"
#include "app/listing/compile_sentences.h"

#include <angelscript.h>

#include <algorithm>

namespace listing {

using namespace AngelScript;

namespace {

/// Releases the memory that the interpreter keeps for a thread when the thread ends.
struct ThreadCleanup
{
    ~ThreadCleanup() { asThreadCleanup(); }
};

}

void prepareScriptThread()
{
    // So that all engines of the process share one thread manager, whichever thread makes the first one.
    static const int prepared = asPrepareMultithread();
    static_cast<void>(prepared);
    static thread_local ThreadCleanup cleanup;
    static_cast<void>(cleanup);
}

ScriptEngine::ScriptEngine(const SourceScan &scan, const Vocabulary &vocabulary)
    : m_scan(scan), m_vocabulary(vocabulary)
{
    prepareScriptThread();
    m_engine = asCreateScriptEngine();
    m_engine->SetMessageCallback(asFUNCTION(messageCallback), this, asCALL_CDECL);
    m_engine->SetEngineProperty(asEP_ALLOW_IMPLICIT_HANDLE_TYPES, 1);
    m_engine->SetEngineProperty(asEP_INIT_GLOBAL_VARS_AFTER_BUILD, 0);
    m_engine->SetEngineProperty(asEP_MAX_STACK_SIZE, 1 << 20);
    m_engine->SetEngineProperty(asEP_AUTO_GARBAGE_COLLECT, 0); // nothing of a listing is collected
}

ScriptEngine::~ScriptEngine()
{
    m_engine->ShutDownAndRelease();
}

void ScriptEngine::addError(int line, int column, std::string sentence)
{
    const auto isOnLine = [&](const CompileError &error) { return error.line == line; };
    if (std::none_of(m_errors.begin(), m_errors.end(), isOnLine))
        m_errors.push_back({line, column, m_scan.lengthAt(line, column), std::move(sentence)});
}

void ScriptEngine::messageCallback(const asSMessageInfo *message, void *self)
{
    auto &engine = *static_cast<ScriptEngine *>(self);
    const SourceScan &scan = engine.m_scan;
    const std::string text = message->message;
    // A variable without a value would hold what an earlier call left behind.
    const bool isWarning = message->type == asMSGTYPE_WARNING &&
                           text.find("is not initialized") == std::string::npos && !isAboutFraction(text);
    if (message->type == asMSGTYPE_INFORMATION || isWarning || text.starts_with("Instead found"))
        return;
    const int line = std::max(1, message->row), column = std::max(1, message->col);
    const std::size_t offset = scan.offsetOf(line, column);
    const Tokens &tokens = scan.tokens();
    auto marked = std::find_if(tokens.begin(), tokens.end(), [&](const Token &token) {
        return offset >= token.offset && offset < token.end();
    });
    if (scan.unclosed() && text.starts_with("Not all paths return"))
        return; // the function is not finished yet
    if (isAboutFraction(text) && !setsFraction(tokens, static_cast<std::size_t>(marked - tokens.begin())))
        return; // the value of an index or of an argument
    MarkedPlace place = {{}, engine.m_vocabulary, scan.declaredNames()};
    if (marked == tokens.end() && isAboutGap(text)) { // at a brace that the text does not have
        const auto before = std::find_if(tokens.begin(), tokens.end(),
                                         [&](const Token &token) { return token.end() == offset; });
        place.isAtLineEnd = before != tokens.end();
        if (place.isAtLineEnd)
            return engine.addError(before->line, before->column, plainSentence(text, place));
    }
    if (marked == tokens.end())
        return engine.addError(line, column, plainSentence(text, place));
    place.isAtLineEnd = isAboutGap(text) && marked != tokens.begin() && (marked - 1)->line < marked->line;
    if (isAboutGap(text) && marked->text == "else")
        return engine.addError(marked->line, marked->column,
                               "This 'else' has no 'if'. The lines that belong to a condition go between '{' "
                               "and '}'.");
    const bool isBehindName = marked != tokens.begin() && marked->kind == Token::Kind::sign &&
                              (marked - 1)->kind == Token::Kind::word;
    if (place.isAtLineEnd || (isAboutChange(text) && isBehindName))
        --marked; // the interpreter points at the word or sign behind it
    else if (marked->text == "." && marked + 1 != tokens.end())
        ++marked; // the interpreter points at the dot before a member
    place.word = std::string(marked->text);
    place.isMember = marked != tokens.begin() && (marked - 1)->text == ".";
    if (marked + 1 != tokens.end())
        place.next = std::string((marked + 1)->text);
    place.form = scan.formOf(place.word);
    engine.addError(marked->line, marked->column, plainSentence(text, place));
}

asIScriptModule *ScriptEngine::build()
{
    if (m_scan.error()) {
        m_errors.push_back(*m_scan.error());
        return nullptr;
    }
    if (m_scan.tokens().empty())
        return nullptr;
    asIScriptModule *module = m_engine->GetModule("listing", asGM_ALWAYS_CREATE);
    const std::string text = m_scan.compiledText();
    module->AddScriptSection("listing", text.data(), text.size());
    const int built = module->Build();
    m_engine->ClearMessageCallback();
    if (m_scan.unclosed()) {
        m_errors.push_back(*m_scan.unclosed());
        return nullptr;
    }
    if (built >= 0) {
        const std::optional<CompileError> unused = unusedValue(m_scan.tokens());
        if (!unused)
            return module;
        m_errors.push_back(*unused);
    }
    if (m_errors.empty())
        addError(1, 1, "This text cannot be compiled.");
    return nullptr;
}

}
