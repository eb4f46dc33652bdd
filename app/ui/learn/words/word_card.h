#pragma once

#include "app/model/text/glossary.h"
#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;

namespace app {

class NarrationText;

/// A card with the meaning of a glossary word, next to the word in the text. Esc or a click elsewhere closes
/// it.
class WordCard : public QFrame
{
    Q_OBJECT

public:
    static constexpr int cardWidth = 320;

    /// `glossary` must outlive this.
    WordCard(const Glossary &glossary, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a glossary word below `place`, in screen coordinates, or above it if there is more room.
    void popUp(const QString &name, const QPoint &place);

signals:
    void stepRequested(const QString &lesson, const QString &step);
    /// Emitted when the learner asks for the whole glossary, with this word first.
    void glossaryRequested(const QString &name);

private:
    void follow(const QUrl &link);

    const Glossary &m_glossary;
    QLabel *m_name;
    NarrationText *m_text;
};

}
