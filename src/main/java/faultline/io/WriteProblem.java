package faultline.io;

/** Why a file cannot be written. */
public enum WriteProblem implements Message.Template {
    IS_FOLDER("this is a folder; expected a file"),
    CANNOT_WRITE("the file cannot be written there"),
    READ_ONLY("the file may not be written"),
    OWN_INPUT("this is the open scenario itself; expected another file"),
    DISK_FULL("the file cannot be written completely, because the disk is full"),
    BROKEN_PIPE("the file cannot be written completely, because its reader has closed it"),
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
