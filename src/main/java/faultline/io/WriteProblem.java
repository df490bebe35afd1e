package faultline.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileStore;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.OptionalLong;

/** Why a file cannot be written. */
public enum WriteProblem implements Message.Template {
    /** The path is a folder. */
    IS_FOLDER("this is a folder; expected a file"),
    /** The path is a device or a pipe, where only a file can be written. */
    IS_DEVICE("this is a device or a pipe; expected a file"),
    /** The folder of the file does not exist. */
    NO_FOLDER("its folder does not exist"),
    /** The file cannot be created in that place. */
    CANNOT_WRITE("the file cannot be written there"),
    /** The program may not create files in the folder. */
    FOLDER_READ_ONLY("writing to its folder is not permitted"),
    /** The file system has no names of this length. */
    NAME_TOO_LONG("its name is too long"),
    /** The file is protected against writing. */
    READ_ONLY("writing to the file is not permitted"),
    /** The file is the open scenario. */
    OWN_INPUT("this is the open scenario itself; expected another file"),
    /** The command has another output that is the same file, through a link. */
    OTHER_OUTPUT("another output is the same file; expected a file of its own"),
    /** The disk is full. */
    DISK_FULL("the file cannot be written completely, because the disk is full"),
    /** The program that reads the output has closed it. */
    BROKEN_PIPE("the file cannot be written completely, because its reader has closed it"),
    /** A signal has ended the program, which then keeps no file that is not complete. */
    PROGRAM_ENDS("the file was not written, because the program is ending"),
    /** Writing ended before the file was complete. */
    INTERRUPTED("the file cannot be written completely");

    /** Less room than this is none: it is the size of the pieces in which a file is written, bytes. */
    private static final long MIN_ROOM = 1 << 16;

    /** The longest name of a file on all common systems, bytes. */
    private static final int MAX_NAME_BYTES = 255;

    private final String english;

    WriteProblem(String english) {
        this.english = english;
    }

    /** Returns why writing a file has failed, given the message of the operating system. */
    static WriteProblem of(Path file, String system) {
        return hasFolder(file) ? of(system, room(file).orElse(Long.MAX_VALUE)) : NO_FOLDER;
    }

    private static boolean hasFolder(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        return folder == null || Files.isDirectory(folder);
    }

    /** Returns why creating a file has failed. */
    static WriteProblem ofCreation(Path file, FileSystemException failure) {
        if (!hasFolder(file)) {
            return NO_FOLDER;
        }
        if (failure instanceof AccessDeniedException) {
            return FOLDER_READ_ONLY;
        }
        Path name = Objects.requireNonNullElse(file.getFileName(), file);
        return isTooLong(name, failure) ? NAME_TOO_LONG : CANNOT_WRITE;
    }

    /**
     * {@return whether a file or folder cannot be used because a name of its path is too long} The operating system
     * says so in the language of the user, so the lengths are compared, too.
     *
     * @param path the path
     * @param failure the failure to use it
     */
    public static boolean isTooLong(Path path, FileSystemException failure) {
        for (Path name : path) {
            if (name.toString().getBytes(StandardCharsets.UTF_8).length > MAX_NAME_BYTES) {
                return true;
            }
        }
        return String.valueOf(failure.getReason()).contains("too long");
    }

    /**
     * Returns the problem that the operating system reports by a message in the language of the user. A full disk is
     * recognised in any language by the room that is left, bytes, the maximum value if it is unknown.
     */
    static WriteProblem of(String system, long room) {
        if (system.contains("Broken pipe")) {
            return BROKEN_PIPE;
        }
        boolean full = system.contains("No space left") || system.contains("quota") || system.contains("disk");
        return full || room < MIN_ROOM ? DISK_FULL : INTERRUPTED;
    }

    /** Returns the room that is left on the disk of a file, bytes; empty if it is on no disk. */
    static OptionalLong room(Path file) {
        try {
            FileStore disk = Files.getFileStore(LinkResolver.resolve(file).getParent());
            return disk.getTotalSpace() > 0 ? OptionalLong.of(disk.getUsableSpace()) : OptionalLong.empty();
        } catch (IOException e) {
            return OptionalLong.empty();
        }
    }

    @Override
    public String key() {
        return "problem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
