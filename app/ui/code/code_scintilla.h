#pragma once

#include <QByteArray>

#include <Qsci/qsciscintillabase.h>

namespace app {

/// Sends a message to Scintilla. A call of SendScintilla is often ambiguous because of its many overloads.
template <class Number = int>
long send(const QsciScintillaBase &view, unsigned int message, Number w = 0, long l = 0)
{
    return view.SendScintilla(message, static_cast<unsigned long>(w), l);
}

/// Sends a message with a text.
template <class Number>
long send(const QsciScintillaBase &view, unsigned int message, Number w, const QByteArray &text)
{
    return view.SendScintilla(message, static_cast<unsigned long>(w), text.constData());
}

/// Replaces the text between two positions.
template <class Position>
void replaceText(const QsciScintillaBase &view, Position from, Position to, const QByteArray &by)
{
    send(view, QsciScintillaBase::SCI_SETTARGETSTART, from);
    send(view, QsciScintillaBase::SCI_SETTARGETEND, to);
    send(view, QsciScintillaBase::SCI_REPLACETARGET, by.size(), by);
}

/// Removes an indicator from the whole text. From now on, fillIndicator() marks text with it.
inline void startIndicator(const QsciScintillaBase &view, int indicator)
{
    send(view, QsciScintillaBase::SCI_SETINDICATORCURRENT, indicator);
    send(view, QsciScintillaBase::SCI_INDICATORCLEARRANGE, 0, send(view, QsciScintillaBase::SCI_GETLENGTH));
}

/// Marks the text between two positions with the indicator that was started last.
inline void fillIndicator(const QsciScintillaBase &view, long from, long to)
{
    send(view, QsciScintillaBase::SCI_INDICATORFILLRANGE, from, to - from);
}

}
