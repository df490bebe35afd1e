package faultline.io;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;

/** Reports each failure to write as one sentence with the name of the file. */
final class FailureReportingStream extends FilterOutputStream {

    private final Path file;

    /** Creates a stream to a file; the path is the one that messages name. */
    FailureReportingStream(Path file, OutputStream out) {
        super(out);
        this.file = file;
    }

    @Override
    public void write(int b) throws IOException {
        try {
            out.write(b);
        } catch (IOException e) {
            throw problem(e);
        }
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        try {
            out.write(bytes, offset, length);
        } catch (IOException e) {
            throw problem(e);
        }
    }

    @Override
    public void flush() throws IOException {
        try {
            out.flush();
        } catch (IOException e) {
            throw problem(e);
        }
    }

    @Override
    public void close() throws IOException {
        try {
            out.close();
        } catch (IOException e) {
            throw problem(e);
        }
    }

    /** Closes the file; an error in completing its content is ignored. */
    void closeIgnoringErrors() {
        try {
            out.close();
        } catch (IOException e) {
            // The file is about to be deleted.
        }
    }

    /** Returns an exception whose message is one sentence. */
    MessageException problem(IOException e) {
        return MessageException.ofWriting(file, e);
    }

    /** Returns an exception whose message is one sentence with a reason that is known. */
    MessageException problem(WriteProblem reason, IOException e) {
        return new MessageException(MessageText.oneLine(file.toString()), reason.with(), e);
    }
}
