package faultline.io;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Set;

/** Makes folders that exist completely or not at all, also if a signal ends the process or the machine crashes. */
public final class AtomicFolder {

    private AtomicFolder() {}

    /**
     * Copies files of a folder, with their places in it, to another folder, and forces the copies to the disk.
     *
     * @param source the folder
     * @param files the files in it or in folders in it
     * @param target the other folder, which is empty or does not exist
     * @throws IOException if a file cannot be copied; then the target does not change
     */
    public static void copy(Path source, Collection<Path> files, Path target) throws IOException {
        Path part = target.toAbsolutePath().resolveSibling(TemporaryFile.newName());
        TemporaryFile.deleteAtExit(part);
        try {
            requireNoEnd(target);
            Files.createDirectories(part);
            Set<Path> folders = new LinkedHashSet<>();
            for (Path file : files) {
                Path copy = part.resolve(source.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
                force(copy);
                folders.add(copy.getParent());
            }
            folders.add(part);
            folders.forEach(TemporaryFile::forceFolder);
            TemporaryFile.keepAliveDuring(() -> {
                requireNoEnd(target);
                Files.move(part, target, StandardCopyOption.REPLACE_EXISTING);
                TemporaryFile.forget(part);
            });
            TemporaryFile.forceFolder(part.getParent());
        } finally {
            TemporaryFolder.deleteTree(part);
            TemporaryFile.forget(part);
        }
    }

    private static void force(Path file) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            channel.force(true);
        }
    }

    /** When the process ends, files are deleted that others may be copied beside. */
    private static void requireNoEnd(Path target) throws IOException {
        if (TemporaryFile.isProgramEnding()) {
            throw new MessageException(target.toString(), WriteProblem.PROGRAM_ENDS.with(), null);
        }
    }
}
