package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no sleep")
class LateChildTest {

    @Test
    void aChildThatIsStartedWhileTheProgramEndsDoesNotOutliveIt() throws Exception {
        String argument = "1000." + System.nanoTime();
        Process program = JavaProcess.builder(LateChild.class.getName(), List.of(argument))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        assertTrue(program.waitFor(60, TimeUnit.SECONDS));
        List<ProcessHandle> children = ProcessHandle.allProcesses()
                .filter(process -> process.info().commandLine().orElse("").endsWith(argument))
                .toList();
        children.forEach(ProcessHandle::destroyForcibly);
        assertEquals(List.of(), children);
        assertEquals(
                "the program is ending\n", new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
    }
}
