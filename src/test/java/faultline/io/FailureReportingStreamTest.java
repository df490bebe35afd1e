package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FailureReportingStreamTest {

    private static final Path FILE = Path.of("a\nb.csv");

    /** A stream that nothing can be done with. */
    private static OutputStream failing(IOException failure) {
        return new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw failure;
            }

            @Override
            public void flush() throws IOException {
                throw failure;
            }

            @Override
            public void close() throws IOException {
                throw failure;
            }
        };
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            No space left on device | the file cannot be written completely, because the disk is full
            Disk quota exceeded     | the file cannot be written completely, because the disk is full
            Broken pipe             | the file cannot be written completely, because its reader has closed it
            Input/output error      | the file cannot be written completely
            """)
    void everyOperationThatFailsNamesTheFileAndTheReason(String system, String reason) {
        IOException failure = new IOException(system);
        FailureReportingStream stream = new FailureReportingStream(FILE, failing(failure));
        for (Executable operation : new Executable[] {
            () -> stream.write(1), () -> stream.write(new byte[3], 0, 3), stream::flush, stream::close
        }) {
            MessageException problem = assertThrows(MessageException.class, operation);
            assertEquals(reason, problem.reason().toString());
            assertEquals(MessageText.oneLine(FILE.toString()), problem.subject());
            assertEquals(1, problem.getMessage().lines().count());
            assertSame(failure, problem.getCause());
        }
    }

    @Test
    void aFileThatIsAbandonedIsClosedWithoutAComplaint() {
        List<String> closed = new ArrayList<>();
        OutputStream out = new OutputStream() {
            @Override
            public void write(int b) {
                fail("nothing is written");
            }

            @Override
            public void close() throws IOException {
                closed.add("the file");
                throw new IOException((String) null);
            }
        };
        new FailureReportingStream(FILE, out).closeIgnoringErrors();
        assertEquals(List.of("the file"), closed);
    }

    @Test
    void aMessageWithoutAFileIsTheReasonAlone() {
        MessageException problem = new MessageException("", WriteProblem.READ_ONLY.with(), null);
        assertEquals("writing to the file is not permitted", problem.getMessage());
        assertEquals("problem.readOnly", WriteProblem.READ_ONLY.key());
    }
}
