package faultline.io;

/** Why a file cannot be written. */
public enum WriteProblem implements Message.Template {
    /** The path is a folder. */
    IS_FOLDER("this is a folder; expected a file"),
    /** The folder of the file does not exist. */
    NO_FOLDER("its folder does not exist"),
    /** The file cannot be created in that place. */
    CANNOT_WRITE("the file cannot be written there"),
    /** The file is protected against writing. */
    READ_ONLY("writing to the file is not permitted"),
    /** The file is the open scenario. */
    OWN_INPUT("this is the open scenario itself; expected another file"),
    /** The disk is full. */
    DISK_FULL("the file cannot be written completely, because the disk is full"),
    /** The program that reads the output has closed it. */
    BROKEN_PIPE("the file cannot be written completely, because its reader has closed it"),
    /** A signal has ended the program, which then keeps no file that is not complete. */
    PROGRAM_ENDS("the file was not written, because the program is ending"),
    /** Writing ended before the file was complete. */
    INTERRUPTED("the file cannot be written completely");

    private final String english;

    WriteProblem(String english) {
        this.english = english;
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
