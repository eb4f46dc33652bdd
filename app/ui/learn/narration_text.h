#pragma once

#include "app/ui/learn/prose.h"

#include <QTextBrowser>

namespace app {

class Glossary;

/// A Markdown text that is as high as its content. It opens https links itself, and emits linkActivated() for others.
class NarrationText : public QTextBrowser
{
    Q_OBJECT

public:
    enum class Kind {
        narration, ///< the text of a step
        aside,     ///< smaller: a hint, an answer, a glossary word
    };

    explicit NarrationText(const Theme &theme, QWidget *parent = nullptr, Kind kind = Kind::narration);

    /// Makes the first occurrence of each glossary word a link. The glossary must outlive this.
    void setGlossary(const Glossary &glossary) { m_glossary = &glossary; }
    void setText(const QString &markdown);
    /// Uses larger type, for large windows.
    void setLarge(bool large);
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, 20}; }

signals:
    /// Emitted when the learner clicks a link; a glossary word has a link made by wordLink(). `place` is below the link,
    /// in screen coordinates.
    void linkActivated(const QUrl &link, const QPoint &place);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    /// Called when the document has been filled again, for example with the colours of another theme.
    virtual void decorate() {}
    QMimeData *createMimeDataFromSelection() const override;

private:
    void applyTheme();
    void follow(const QUrl &link);

    const Theme &m_theme;
    const Glossary *m_glossary = nullptr;
    Kind m_kind;
    QString m_text;
    bool m_large = false;
    mutable ProseHeights m_heights;
};

}
