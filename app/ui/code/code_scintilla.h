#pragma once

#include <Qsci/qsciscintillabase.h>

#include <cstddef>

namespace app {

/// Sends a message to Scintilla. A call of SendScintilla is often ambiguous because of its many overloads.
inline long send(const QsciScintillaBase &view, unsigned int message, std::size_t w = 0, long l = 0)
{
    return view.SendScintilla(message, static_cast<unsigned long>(w), l);
}

}
