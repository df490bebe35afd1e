package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A run in a corridor of 100 km, along which there are 20 million places for the coverage. */
class LongPathTest {

    @TempDir
    private Path folder;

    private Path trace;

    @BeforeEach
    void aLongCorridor() throws IOException {
        trace = folder.resolve("trace.csv");
        Files.writeString(
                folder.resolve("corridor.xml"),
                "<scenario xmlns=\"urn:faultline:scenario:1\" duration=\"15\"><world width=\"100000\" height=\"1\"/>"
                        + "<robot x=\"1\" y=\"0.5\" heading=\"180\"/>"
                        + "<controller type=\"wall-follower\" distance=\"0.25\"/>"
                        + "<expect minCoverage=\"0.5\"/></scenario>");
    }

    private Process run(String heap) throws IOException {
        return JavaProcess.startWithHeap(
                heap,
                "faultline.app.Main",
                List.of("run", folder.resolve("corridor.xml").toString(), "--trace", trace.toString()));
    }

    @Test
    void thereIsNoCoverageAlongAPathOfTooManyPlaces() throws Exception {
        Process process = run("1g");
        String output = JavaProcess.output(process);
        assertTrue(output.contains("\ncoverage: none\n"), output);
        assertTrue(
                output.endsWith("expectations: failed\n"
                        + "the coverage is not known: the path along the wall has too many places; expected at most"
                        + " 4000000\nexpected a coverage of at least 0.5, but it is not known\n"),
                output);
        assertEquals(ExitCode.EXPECTATION_FAILED, process.waitFor());
        assertEquals(1502, Files.readAllLines(trace).size());
    }

    @Test
    void aCoverageThatNeedsTooMuchMemoryKeepsTheOutputs() throws Exception {
        Process process = run("64m");
        assertEquals("faultline: there is not enough memory\n", JavaProcess.output(process));
        assertEquals(ExitCode.RUN_FAILED, process.waitFor());
        assertEquals(1502, Files.readAllLines(trace).size());
    }
}
