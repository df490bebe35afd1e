package faultline.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Set;

/** Sets permissions of files. */
public final class FilePermissions {

    private FilePermissions() {}

    /**
     * Sets the permissions of a file or folder, if its file system can. A file system of Windows that is mounted in
     * Linux, or one on a network, may refuse, or not have any; the file keeps those that it has.
     *
     * @param file the file or folder
     * @param permissions the permissions
     */
    public static void setIfPossible(Path file, Set<PosixFilePermission> permissions) {
        if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            try {
                Files.setPosixFilePermissions(file, permissions);
            } catch (IOException e) {
                // A file with the wrong permissions is better than none.
            }
        }
    }
}
