package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StandardInputTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnabledOnOs(value = OS.LINUX, disabledReason = "elsewhere the number of the file is not known")
    @CsvSource({"serve, hello", "controller, ''"})
    void aClosedInputHasEnded(String command, String answer) throws Exception {
        Path room = Files.writeString(
                folder.resolve("room.xml"),
                "<scenario xmlns='urn:faultline:scenario:1' duration='1'><world width='3' height='3'/>"
                        + "<robot x='1.2' y='1'/></scenario>");
        List<String> shell = new ArrayList<>(List.of("sh", "-c", "exec \"$@\" <&-", "sh"));
        shell.addAll(JavaProcess.program());
        shell.addAll(List.of(command, room.toString()));
        Process process = new ProcessBuilder(shell).redirectErrorStream(true).start();
        String output = JavaProcess.output(process);
        assertEquals(0, process.waitFor(), output);
        assertTrue(output.contains(answer), output);
        assertEquals(answer.isEmpty() ? 0 : 1, output.lines().count(), output);
    }
}
