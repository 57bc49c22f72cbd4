export * from "blockly/msg/es";
