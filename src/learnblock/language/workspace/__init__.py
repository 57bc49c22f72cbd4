"""Read and write workspaces of Blockly."""
