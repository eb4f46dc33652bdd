#pragma once

#include <QStringList>
#include <QTextCursor>

#include <vector>

class QImage;
class QTextDocument;

namespace app {

/// Writes parts of a handout, one below the other.
class Paper
{
public:
    /// `document` must outlive this object. Its former contents are removed.
    explicit Paper(QTextDocument &document);

    /// `level` from 1 to 3.
    void addHeading(int level, const QString &text);
    /// Adds paragraphs of Markdown. Links to words are plain text.
    void addText(const QString &markdown);
    /// Adds a paragraph of Markdown with a bullet.
    void addItem(const QString &markdown);
    /// Adds an answer with a box to tick.
    void addChoice(const QString &markdown);
    void addCode(const QString &code);
    /// Adds empty lines to write on.
    void addLines(int count);
    /// Adds one line with a space to write on after each name.
    void addFields(const QStringList &names);
    /// Does nothing for a null picture.
    void addPicture(const QImage &picture);
    /// Adds curves beside each other, numbered from 1, with the same scale.
    void addCurves(const std::vector<std::vector<double>> &curves);
    /// What comes next is on a new page.
    void beginPage();

private:
    void beginBlock(qreal top, qreal left = 0.0);
    void addMarkdown(const QString &markdown, qreal top, qreal left, const QString &mark);

    QTextCursor m_cursor;
    bool m_beginsPage = false;
};

}
