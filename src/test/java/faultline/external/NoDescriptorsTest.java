package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.JavaProcess;
import java.io.FileInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A program that has no free file descriptor ends its child nevertheless. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "limits the descriptors by ulimit")
class NoDescriptorsTest {

    private static final String STUBBORN = "trap '' TERM; echo ready >&2; while :; do sleep 1; done";

    /** Closes a child when all descriptors are used, and prints whether it is alive after that. */
    public static final class Program {

        private Program() {}

        /** Runs the program. */
        public static void main(String[] arguments) throws Exception {
            // Loads the classes, which need a descriptor.
            new ChildProcess(List.of("sh", "-c", "exit 0"), 10, line -> {}).close();
            CountDownLatch ready = new CountDownLatch(1);
            ChildProcess child = new ChildProcess(List.of("sh", "-c", STUBBORN), 10, line -> ready.countDown());
            ready.await();
            ProcessHandle process =
                    ProcessHandle.current().children().findFirst().orElseThrow();
            List<FileInputStream> files = new ArrayList<>();
            try {
                while (true) {
                    files.add(new FileInputStream("/dev/null"));
                }
            } catch (IOException noneFree) {
                child.close();
            }
            for (FileInputStream file : files) {
                file.close();
            }
            System.out.print(process.isAlive());
        }
    }

    @Test
    void theChildEnds() throws IOException {
        List<String> command = new ArrayList<>(List.of("sh", "-c", "ulimit -n 200; exec \"$@\"", "sh"));
        command.addAll(JavaProcess.builder(Program.class.getName(), List.of()).command());
        Process program = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        assertEquals("false", JavaProcess.output(program));
    }
}
