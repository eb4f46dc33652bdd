#pragma once

#include <QString>

namespace app {

/// A file of the run that is made piece by piece. Between two pieces the caller can repaint the window, show the
/// progress, or cancel.
class Export
{
public:
    virtual ~Export() = default;

    /// Makes the next piece, for some milliseconds. Returns false when the file is finished and written.
    /// @throws UserError if the file cannot be written
    virtual bool goOn() = 0;
    /// Returns the frame that is being processed.
    virtual std::int64_t frame() const = 0;
    /// Returns how many pieces of total() are done.
    virtual std::int64_t done() const = 0;
    virtual std::int64_t total() const = 0;
    /// Returns why the file ends before the requested last frame, as endSentence(). Empty if it does not.
    const QString &endsEarly() const { return m_endsEarly; }

protected:
    QString m_endsEarly;
};

}
