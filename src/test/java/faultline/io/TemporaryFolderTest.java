package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Temporary folders of processes that end in different ways. */
@Timeout(120)
class TemporaryFolderTest {

    private static final String PREFIX = "faultline-test-";

    @TempDir
    private Path parent;

    /** Makes a folder with contents, prints its path, and ends at the end of its input. */
    static final class Owner {

        private Owner() {}

        public static void main(String[] arguments) throws IOException {
            TemporaryFolder folder = TemporaryFolder.create(PREFIX);
            Files.writeString(
                    Files.createDirectories(folder.path().resolve("results")).resolve("runs.csv"), "run\n");
            System.out.println(folder.path());
            while (System.in.read() >= 0) {
                Files.writeString(folder.path().resolve("results/more.csv"), "run\n");
            }
            if (arguments.length > 0) {
                folder.delete();
                System.out.println(Files.exists(folder.path()));
            }
        }
    }

    private Process start(String... arguments) throws IOException {
        ProcessBuilder builder = JavaProcess.builder(Owner.class.getName(), List.of(arguments));
        builder.command().add(1, "-Djava.io.tmpdir=" + parent);
        return builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }

    private static Path folder(Process owner) throws IOException {
        return Path.of(owner.inputReader(StandardCharsets.UTF_8).readLine());
    }

    private List<Path> folders() throws IOException {
        try (Stream<Path> paths = Files.list(parent)) {
            return paths.sorted().toList();
        }
    }

    /** Makes the lock of a folder as old as one that is not being created. */
    private static void age(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Files.setLastModifiedTime(file, FileTime.fromMillis(System.currentTimeMillis() - 60_000));
            }
        }
    }

    /** In this process, so that the coverage counts it: no other folder has the prefix. */
    @Test
    void anAbandonedFolderIsDeletedWithItsContentsAndOthersStay() throws IOException {
        String prefix = "faultline-" + Long.toUnsignedString(System.nanoTime()) + "-";
        Path left = Files.createTempDirectory(prefix);
        Path other = Files.createTempDirectory(prefix);
        Path recent = Files.createTempDirectory(prefix);
        try {
            Files.createFile(left.resolve(".faultline-1.tmp"));
            age(left);
            Files.writeString(Files.createDirectories(left.resolve("results")).resolve("runs.csv"), "run\n");
            Files.createFile(other.resolve("runs.csv"));
            Files.createFile(recent.resolve(".faultline-1.tmp"));
            TemporaryFolder first = TemporaryFolder.create(prefix);
            assertEquals(
                    List.of(false, true, true),
                    Stream.of(left, other, recent).map(Files::exists).toList());
            age(first.path());
            TemporaryFolder second = TemporaryFolder.create(prefix);
            assertTrue(Files.exists(first.path()), "a folder of this process");
            first.delete();
            second.delete();
            assertFalse(Files.exists(first.path()) || Files.exists(second.path()));
        } finally {
            for (Path folder : List.of(left, other, recent)) {
                TemporaryFolder.deleteTree(folder);
            }
        }
    }

    @Test
    void aFolderIsDeletedByItsOwnerOrWhenTheProcessEnds() throws Exception {
        for (String[] arguments : List.of(new String[0], new String[] {"delete"})) {
            Process owner = start(arguments);
            assertTrue(Files.exists(folder(owner).resolve("results/runs.csv")));
            owner.getOutputStream().close();
            assertEquals(0, owner.waitFor());
            assertEquals(List.of(), folders());
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void aSignalDeletesTheFolder() throws Exception {
        Process owner = start();
        folder(owner);
        JavaProcess.signal("-TERM", owner.toHandle());
        assertEquals(143, owner.waitFor());
        assertEquals(List.of(), folders());
    }

    @Test
    void theFolderOfAKilledProcessIsDeletedByTheNextAndThatOfALiveOneStays() throws Exception {
        Process live = start();
        Path used = folder(live);
        age(used);
        Process killed = start();
        Path left = folder(killed);
        killed.destroyForcibly().waitFor();
        age(left);
        Path other = Files.createDirectory(parent.resolve(PREFIX + "of-another-program"));
        assertTrue(Files.exists(left));
        Process next = start();
        Path newest = folder(next);
        assertEquals(Stream.of(used, other, newest).sorted().toList(), folders());
        next.destroyForcibly().waitFor();
        live.destroyForcibly().waitFor();
        assertFalse(Files.exists(left));
    }
}
