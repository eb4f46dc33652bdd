#pragma once

#include <Qsci/qsciscintillabase.h>

#include <cstddef>

namespace app {

/// Sends a message to Scintilla: the call without the ambiguity of SendScintilla's many forms.
inline long send(const QsciScintillaBase &view, unsigned int message, std::size_t w = 0, long l = 0)
{
    return view.SendScintilla(message, static_cast<unsigned long>(w), l);
}

}
