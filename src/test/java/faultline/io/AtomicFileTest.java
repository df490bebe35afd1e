package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.JavaProcess;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AtomicFileTest {

    @TempDir
    private Path folder;

    private void write(Path file, String text, boolean commit) throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(text.getBytes(StandardCharsets.UTF_8));
            if (commit) {
                out.commit();
            }
        }
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    @Test
    void aCommittedFileTakesTheOldOnesPlace() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        write(file, "new", true);
        assertEquals("new", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    /** An open file is a leak, and on some systems it cannot be replaced. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void nothingCanBeWrittenAfterTheEnd(boolean commit) throws IOException {
        AtomicFile out = AtomicFile.create(folder.resolve("a.txt"));
        if (commit) {
            out.commit();
        }
        out.close();
        assertThrows(IOException.class, () -> out.stream().write(new byte[1 << 20]));
    }

    /** Long enough to be forced to the disk while it is written. */
    @Test
    void aLongFileIsWholeAfterItsCommit() throws IOException {
        Path file = folder.resolve("long.bin");
        byte[] block = new byte[1 << 20];
        try (AtomicFile out = AtomicFile.create(file)) {
            for (int i = 0; i < 50; i++) {
                Arrays.fill(block, (byte) i);
                out.stream().write(block);
            }
            out.stream().write(77);
            out.commit();
        }
        byte[] content = Files.readAllBytes(file);
        assertEquals(50 * block.length + 1, content.length);
        for (int i = 0; i < content.length - 1; i += 4093) {
            assertEquals(i / block.length, content[i]);
        }
        assertEquals(77, content[content.length - 1]);
        assertEquals(List.of(file), files());
    }

    @Test
    void aLongFileThatIsNotCommittedLeavesNothing() throws IOException {
        try (AtomicFile out = AtomicFile.create(folder.resolve("long.bin"))) {
            out.stream().write(new byte[40 << 20]);
        }
        assertEquals(List.of(), files());
    }

    @Test
    void withoutACommitTheOldFileStaysAndNothingElse() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        write(file, "new", false);
        assertEquals("old", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    @Test
    void ofTwoThatAreWrittenAtOnceTheLastCommittedOneIsThereAsAWhole() throws IOException {
        Path file = folder.resolve("a.txt");
        try (AtomicFile one = AtomicFile.create(file);
                AtomicFile other = AtomicFile.create(file)) {
            one.stream().write("the longer one".getBytes(StandardCharsets.UTF_8));
            other.stream().write("other".getBytes(StandardCharsets.UTF_8));
            one.commit();
            assertEquals("the longer one", Files.readString(file));
            other.commit();
        }
        assertEquals("other", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    @Test
    void aLinkStaysALink() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("link.txt"), file);
        write(link, "new", true);
        assertEquals("new", Files.readString(file));
        assertEquals(file, Files.readSymbolicLink(link));
    }

    @Test
    void aFolderIsRefused() {
        assertEquals(
                folder + ": this is a folder; expected a file",
                assertThrows(IOException.class, () -> AtomicFile.create(folder)).getMessage());
    }

    private static String mode(Path file) throws IOException {
        return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
    }

    @Test
    void theNewFileHasThePermissionsOfTheOldOne() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        for (String permissions : List.of("rw-------", "rw-r-----", "rwxrwxrwx")) {
            Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
            write(file, "new", true);
            assertEquals(permissions, mode(file));
        }
    }

    @Test
    void aSecretFileIsForItsOwnerAlsoInThePlaceOfAPublicOne() throws IOException {
        Path file = folder.resolve("a.txt");
        for (String permissions : List.of("rw-------", "rw-rw-rw-")) {
            AtomicFile.writeSecret(file, new byte[] {1});
            assertEquals("rw-------", mode(file));
            Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
        }
        AtomicFile.writeSecret(file, new byte[] {2});
        assertEquals("rw-------", mode(file));
    }

    @Test
    void aFileThatWasNotThereHasThePermissionsOfAnyNewFile() throws IOException {
        Path usual = Files.createFile(folder.resolve("usual"));
        write(folder.resolve("a.txt"), "new", true);
        assertEquals(mode(usual), mode(folder.resolve("a.txt")));
    }

    @Test
    void whileItIsWrittenOnlyItsOwnerMayReadIt() throws IOException {
        try (AtomicFile out = AtomicFile.create(folder.resolve("a.txt"))) {
            assertEquals(List.of("rw-------"), List.of(mode(files().get(0))));
            out.commit();
        }
    }

    @Test
    void whileAPublicFileIsReplacedOnlyItsOwnerMayReadTheNewContent() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw-rw-"));
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(1);
            assertEquals(List.of("rw-------", "rw-rw-rw-"), List.of(mode(files().get(0)), mode(files().get(1))));
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aLinkThatSomeoneHasPlantedAtTheTemporaryNameIsNotFollowed(boolean replace) throws IOException {
        Path victim = Files.writeString(folder.resolve("victim"), "precious");
        Path file = folder.resolve("a.txt");
        if (replace) {
            Files.writeString(file, "old");
        }
        PlantedLinks attacker = new PlantedLinks(victim, 3);
        write(attacker.forwarding(file), "new", true);
        assertEquals(3, Set.copyOf(attacker.links()).size(), "each time another name");
        for (Path link : attacker.links()) {
            assertEquals(victim, Files.readSymbolicLink(link));
        }
        assertEquals("precious", Files.readString(victim));
        assertEquals("new", Files.readString(file));
        assertFalse(Files.isSymbolicLink(file));
        assertEquals(5, files().size());
    }

    @Test
    void aLongNameIsWrittenAndATooLongOneIsReportedAtOnce() throws IOException {
        Path file = folder.resolve("x".repeat(250) + ".csv");
        write(file, "new", true);
        assertEquals(List.of(file), files());
        Path tooLong = folder.resolve("x".repeat(300));
        assertEquals(
                tooLong + ": its name is too long",
                assertThrows(IOException.class, () -> AtomicFile.create(tooLong))
                        .getMessage());
    }

    @Test
    void aLinkToAFileThatIsNotThereYetStaysALink() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("link.txt"), Path.of("a.txt"));
        write(link, "new", true);
        assertEquals("new", Files.readString(folder.resolve("a.txt")));
        assertTrue(Files.isSymbolicLink(link));
    }

    @Test
    void linksInALoopAreReported() throws IOException {
        Path one = Files.createSymbolicLink(folder.resolve("one"), Path.of("two"));
        Files.createSymbolicLink(folder.resolve("two"), Path.of("one"));
        assertEquals(
                one + ": the file cannot be written there",
                assertThrows(IOException.class, () -> AtomicFile.create(one)).getMessage());
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "open files cannot be deleted")
    void aFolderThatIsDeletedMeanwhileIsReported() throws IOException {
        Path deleted = Files.createDirectory(folder.resolve("deleted"));
        try (AtomicFile out = AtomicFile.create(deleted.resolve("a.txt"))) {
            out.stream().write(1);
            TemporaryFolder.deleteTree(deleted);
            assertEquals(
                    deleted.resolve("a.txt") + ": its folder does not exist",
                    assertThrows(IOException.class, out::commit).getMessage());
        }
    }

    @Test
    void aFullDiskIsOneSentenceWithTheNameOfTheFile() throws IOException {
        Path full = Path.of("/dev/full");
        assumeTrue(Files.exists(full));
        try (AtomicFile out = AtomicFile.create(full)) {
            out.stream().write(1);
            assertEquals(
                    "/dev/full: the file cannot be written completely, because the disk is full",
                    assertThrows(IOException.class, out::commit).getMessage());
        }
    }

    /** As in {@code --trace /dev/fd/7 7>>all.csv}. */
    @Test
    void whatIsWrittenToAnInheritedFileIsAppended() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old ");
        try (FileChannel inherited = FileChannel.open(file, StandardOpenOption.WRITE)) {
            assertEquals(4, inherited.size());
            write(descriptor(file), "new", true);
        }
        assertEquals("old new", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    /** Returns the descriptor with which this process has opened a file. */
    private static Path descriptor(Path file) throws IOException {
        Path own = Path.of("/proc/self/fd");
        assumeTrue(Files.isDirectory(own));
        try (Stream<Path> descriptors = Files.list(own)) {
            return descriptors
                    .filter(each -> LinkResolver.findConflict(List.of(file), List.of(each))
                            .isPresent())
                    .findFirst()
                    .orElseThrow();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "a.txt, a.txt",
        "a.txt, ./a.txt",
        "a.txt, sub/../a.txt",
        "a.txt, link.txt",
        "a.txt, hard.txt",
        "a.txt, linked/a.txt",
        "new.txt, linked/new.txt",
        "new.txt, dangling.txt",
        "link.txt, hard.txt"
    })
    void twoPathsOfOneFileAreInConflict(String one, String other) throws IOException {
        prepareLinks();
        Path output = folder.resolve(other);
        assertEquals(Optional.of(output), LinkResolver.findConflict(List.of(folder.resolve(one)), List.of(output)));
        assertEquals(Optional.of(output), LinkResolver.findConflict(List.of(), List.of(folder.resolve(one), output)));
    }

    @ParameterizedTest
    @CsvSource({"a.txt, b.txt", "new.txt, other.txt", "a.txt, sub/a.txt", "/dev/null, /dev/null"})
    void pathsOfDifferentFilesAndOfADeviceAreNotInConflict(String one, String other) throws IOException {
        prepareLinks();
        assertEquals(
                Optional.empty(),
                LinkResolver.findConflict(List.of(), List.of(folder.resolve(one), folder.resolve(other))));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "there are no named pipes")
    void aNamedPipeIsOneOutputOnly() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        Path link = Files.createSymbolicLink(folder.resolve("pipe-link"), pipe);
        assertEquals(Optional.of(link), LinkResolver.findRepeatedPipe(List.of(pipe, folder.resolve("a"), link)));
        assertEquals(Optional.empty(), LinkResolver.findRepeatedPipe(List.of(pipe, folder.resolve("a"))));
        assertEquals(Optional.empty(), LinkResolver.findConflict(List.of(pipe), List.of(pipe)));
    }

    /** {@code /dev/null} is no pipe, and the standard output, which may be one, is inherited. */
    @ParameterizedTest
    @ValueSource(strings = {"/dev/null", "/dev/stdout", "/dev/stderr", "new.txt"})
    void anotherOutputIsNoRepeatedPipe(String name) {
        Path file = folder.resolve(name);
        assertEquals(Optional.empty(), LinkResolver.findRepeatedPipe(List.of(file, file)));
    }

    private void prepareLinks() throws IOException {
        Files.createDirectory(folder.resolve("sub"));
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        Files.writeString(folder.resolve("b.txt"), "old");
        Files.createSymbolicLink(folder.resolve("link.txt"), Path.of("a.txt"));
        Files.createLink(folder.resolve("hard.txt"), file);
        Files.createSymbolicLink(folder.resolve("linked"), folder);
        Files.createSymbolicLink(folder.resolve("dangling.txt"), Path.of("new.txt"));
    }

    /** Ends while a file is written. After its temporary file was deleted, commits it, and begins another. */
    static final class EndingWriter {

        private EndingWriter() {}

        public static void main(String[] arguments) throws Exception {
            Path folder = Path.of(arguments[0]);
            AtomicFile first = AtomicFile.create(folder.resolve("first.txt"));
            Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                while (hasFiles(folder)) {
                    Thread.onSpinWait();
                }
                try {
                    first.commit();
                } catch (IOException refused) {
                    System.out.println(refused.getMessage());
                }
                try {
                    AtomicFile.create(folder.resolve("second.txt"));
                } catch (IOException refused) {
                    System.out.println(refused.getMessage());
                }
            }));
            first.stream().write('x');
            System.exit(0);
        }

        private static boolean hasFiles(Path folder) {
            try (Stream<Path> files = Files.list(folder)) {
                return files.findAny().isPresent();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    @Test
    @Timeout(60)
    void noFileIsWrittenWhileTheProcessEndsAndTheSentenceSaysSo() throws Exception {
        Process process = JavaProcess.builder(EndingWriter.class.getName(), List.of(folder.toString()))
                .start();
        String output = JavaProcess.output(process);
        assertEquals(0, process.waitFor());
        String reason = ": the file was not written, because the program is ending";
        assertEquals(
                List.of(folder.resolve("first.txt") + reason, folder.resolve("second.txt") + reason),
                output.lines().toList());
        assertEquals(List.of(), files());
    }

    @Test
    void whatAKilledProcessHasLeftIsDeletedUnlessItIsStillWritten() throws IOException {
        Path killed = Files.createFile(folder.resolve(".faultline-1.tmp"));
        Path young = Files.createFile(folder.resolve(".faultline-2.tmp"));
        Path notes = Files.createFile(folder.resolve(".faultline-notes"));
        Path other = Files.createFile(folder.resolve(".other.tmp"));
        Path written = Files.createFile(folder.resolve(".faultline-3.tmp"));
        FileTime old = FileTime.from(Instant.now().minusSeconds(60));
        for (Path file : List.of(killed, notes, other, written)) {
            Files.setLastModifiedTime(file, old);
        }
        try (FileChannel channel = FileChannel.open(written, StandardOpenOption.WRITE)) {
            channel.lock();
            write(folder.resolve("a.txt"), "new", true);
        }
        assertEquals(List.of(young, written, notes, other, folder.resolve("a.txt")), files());
    }

    /** The temporary files of another user cannot be opened. */
    private static final class SharedFolder extends ForwardingFileSystemProvider {
        @Override
        public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
                throws IOException {
            if (path.toString().contains("foreign")) {
                throw new AccessDeniedException(path.toString());
            }
            return super.newFileChannel(path, options, attributes);
        }
    }

    @Test
    void filesOfAnotherUserDoNotKeepWhatAKilledProcessHasLeft() throws IOException {
        for (int i = 0; i < 20; i++) {
            String name = ".faultline-" + i + (i % 4 == 3 ? "-foreign" : "") + ".tmp";
            Files.setLastModifiedTime(
                    Files.createFile(folder.resolve(name)),
                    FileTime.from(Instant.now().minusSeconds(60)));
        }
        AtomicFile.write(new SharedFolder().forwarding(folder.resolve("a.txt")), new byte[] {'x'});
        List<Path> left = files();
        assertEquals(6, left.size(), left::toString);
        assertTrue(left.stream()
                .allMatch(file -> file.endsWith("a.txt") || file.toString().endsWith("-foreign.tmp")));
    }

    @Test
    @Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no named pipes in folders")
    void aPipeOrALinkWithTheNameOfATemporaryFileIsNotOpened() throws Exception {
        Path victim = Files.createFile(folder.resolve("victim"));
        Path link = Files.createSymbolicLink(folder.resolve(".faultline-2.tmp"), victim);
        // Java would open the pipe to set its time.
        for (String command : List.of("mkfifo .faultline-1.tmp", "touch -t 200001010000 .faultline-1.tmp victim")) {
            Process process = new ProcessBuilder(command.split(" "))
                    .directory(folder.toFile())
                    .start();
            assertEquals(0, process.waitFor());
        }
        write(folder.resolve("a.txt"), "new", true);
        Path pipe = folder.resolve(".faultline-1.tmp");
        assertEquals(List.of(pipe, link, folder.resolve("a.txt"), victim), files());
    }
}
