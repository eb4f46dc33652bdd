#pragma once

#include "app/model/glossary.h"
#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;

namespace app {

class NarrationText;

/// What a word means, on a card beside the text in which it stands. Esc or a click elsewhere closes it.
class WordCard : public QFrame
{
    Q_OBJECT

public:
    static constexpr int cardWidth = 320;

    /// `glossary` must outlive this.
    WordCard(const Glossary &glossary, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a word of the glossary at `place` on the screen, or above it where there is more room.
    void popUp(const QString &name, const QPoint &place);

signals:
    void stepAsked(const QString &lesson, const QString &step);
    /// All words were asked for, this one first.
    void glossaryAsked(const QString &name);

private:
    void follow(const QUrl &link);

    const Glossary &m_glossary;
    QLabel *m_name;
    NarrationText *m_text;
};

}
