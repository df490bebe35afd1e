package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.JavaProcess;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Files that take their places together. */
class CommitAllTest {

    @TempDir
    private Path folder;

    /** Two files, and what happens before the second is used. */
    private static final class InterruptedPair extends AbstractList<AtomicFile> {

        private final List<AtomicFile> files;
        private final Runnable beforeSecond;

        InterruptedPair(AtomicFile first, AtomicFile second, Runnable beforeSecond) throws IOException {
            files = List.of(first, second);
            this.beforeSecond = beforeSecond;
            for (AtomicFile file : files) {
                file.stream().write('x');
            }
        }

        @Override
        public AtomicFile get(int index) {
            if (index == 1) {
                beforeSecond.run();
            }
            return files.get(index);
        }

        @Override
        public int size() {
            return files.size();
        }
    }

    private static List<String> names(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean hasTemporaryFile(Path folder) {
        return names(folder).stream().anyMatch(name -> name.endsWith(".tmp"));
    }

    /**
     * Begins to end when the first of two files is in place, and continues with the second when the end waits for it or
     * has deleted it.
     */
    static final class EndingMoves {

        private EndingMoves() {}

        public static void main(String[] arguments) throws IOException {
            Path folder = Path.of(arguments[0]);
            Path first = folder.resolve("first");
            AtomicFile.commitAll(
                    new InterruptedPair(AtomicFile.create(first), AtomicFile.create(folder.resolve("second")), () -> {
                        if (Files.exists(first)) {
                            new Thread(() -> System.exit(0)).start();
                            while (hasTemporaryFile(folder) && !isEndWaiting()) {
                                Thread.onSpinWait();
                            }
                        }
                    }));
        }

        private static boolean isEndWaiting() {
            return Thread.getAllStackTraces().keySet().stream()
                    .anyMatch(thread -> thread.getName().equals("delete temporary files")
                            && thread.getState() == Thread.State.TIMED_WAITING);
        }
    }

    @Test
    @Timeout(60)
    void ifTheProcessBeginsToEndBetweenTwoMovesBothFilesAreInPlace() throws Exception {
        run(EndingMoves.class);
        assertEquals(List.of("first", "second"), names(folder));
    }

    /** If the last byte were still in a buffer when the file is forced, a power failure could lose it. */
    @Test
    void theContentIsOutOfTheBufferBeforeTheNextFileIsCompleted() throws IOException {
        List<Long> sizes = new ArrayList<>();
        try (AtomicFile first = AtomicFile.create(folder.resolve("first"));
                AtomicFile second = AtomicFile.create(folder.resolve("second"))) {
            AtomicFile.commitAll(new InterruptedPair(first, second, () -> sizes.add(totalSize())));
        }
        assertEquals(1, sizes.get(0));
    }

    private long totalSize() {
        try (Stream<Path> files = Files.list(folder)) {
            return files.mapToLong(file -> file.toFile().length()).sum();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void run(Class<?> program) throws IOException, InterruptedException {
        Process process = JavaProcess.builder(program.getName(), List.of(folder.toString()))
                .start();
        JavaProcess.output(process);
        assertEquals(0, process.waitFor());
    }

    @Test
    void ifOneFileIsNotCompleteNoneTakesItsPlace() throws IOException {
        Path full = Path.of("/dev/full");
        assumeTrue(Files.exists(full));
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        try (AtomicFile first = AtomicFile.create(file);
                AtomicFile second = AtomicFile.create(full)) {
            List<AtomicFile> both = new InterruptedPair(first, second, () -> {});
            assertThrows(IOException.class, () -> AtomicFile.commitAll(both));
        }
        assertEquals("old", Files.readString(file));
        assertEquals(List.of("a.txt"), names(folder));
    }

    /**
     * Lets the files in a folder look older than they are, writes another, and deletes what seems to be left from
     * killed processes. Setting the time of a file would end a lock of the own process.
     */
    static final class OtherWriter {

        private OtherWriter() {}

        public static void main(String[] arguments) throws IOException {
            Path folder = Path.of(arguments[0]);
            for (String name : names(folder)) {
                Files.setLastModifiedTime(folder.resolve(name), FileTime.fromMillis(1));
            }
            AtomicFile.write(folder.resolve("other"), new byte[] {'x'});
        }
    }

    @Test
    @Timeout(60)
    void anotherProcessDoesNotDeleteAFileThatOnlyWaitsForTheOthers() throws IOException {
        try (AtomicFile first = AtomicFile.create(folder.resolve("first"));
                AtomicFile second = AtomicFile.create(folder.resolve("second"))) {
            AtomicFile.commitAll(new InterruptedPair(first, second, () -> {
                if (!Files.exists(folder.resolve("other"))) {
                    writeFromAnotherProcess();
                }
            }));
        }
        assertEquals(List.of("first", "other", "second"), names(folder));
    }

    private void writeFromAnotherProcess() {
        try {
            run(OtherWriter.class);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
